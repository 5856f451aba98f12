// Results of one design under several conditions, as one.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

struct ScenarioResult {
  std::string name;
  double weight = 1.0;
  Json result;  // "lindqvist", "cycle", "metrics", "process", "programs" as far as they were evaluated
};

// The first result with its loads (keys that end in _N) replaced: by the mean with the weights, half widths
// of intervals by those of that mean, the scenarios' errors independent of each other; or, by_worst, each by
// the largest in size. max_load_N is the largest either way. "scenarios" is added: list of {"name", "weight"}
// with "lindqvist", "cycle", "programs" of each. Lindqvist's "valid" is true where it is for all.
Json combined(const std::vector<ScenarioResult>& scenarios, bool by_worst);

}  // namespace icebow
