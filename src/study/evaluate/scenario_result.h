// Results of one design under several conditions, as one.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

struct ScenarioResult {
  std::string name;
  double weight = 1.0;
  Json result;  // "lindqvist", "cycle", "metrics", "simulation", "programs" ... as far as they were evaluated
};

// The first result with its loads (keys that end in _N) replaced: by the mean with the weights, half widths
// of intervals by those of that mean, the scenarios' errors independent of each other; or, by_worst, each by
// the largest in size. max_load_N is the largest either way. effective_samples are those of the combined
// interval: Welch's and Satterthwaite's for the mean, by_worst those of the scenario whose interval it is.
// "scenarios" is added: list of {"name", "weight"} with "lindqvist", "cycle", "programs" and, of a
// simulation, "metrics" and "simulation" of each. Lindqvist's "valid" is true where it is for all.
Json combined(const std::vector<ScenarioResult>& scenarios, bool by_worst);

// What a result says of one of its scenarios, full scale.
struct ScenarioLoad {
  std::string name;
  double weight = 1.0;
  double mean = 0.0;  //!< simulated, or of the cycle, or Lindqvist's total [N]; NaN: none
  double ci95 = 0.0;  //!< half width of its 95 % interval [N]; NaN: none
};
// Empty where the result is of one condition.
std::vector<ScenarioLoad> scenario_loads(const Json& result);

// A design is evaluated in one scenario after the other. What the first ones gave is kept in files of its
// directory, so that a run that was cut short goes on behind them. `key` is that of the scenario's own case.
// Null where there is no such file, or it is damaged.
Json kept_scenario(const std::string& design_directory, const std::string& key);
// Throws RuntimeError where it cannot be written.
void keep_scenario(const std::string& design_directory, const std::string& key, const Json& result);
bool is_kept_scenario(const std::string& file_name);
void remove_kept_scenarios(const std::string& design_directory);

}  // namespace icebow
