// A response that costs little beside the load a study searches: the breaking cycle or the formula over the
// study's variables, as a smooth function.
#pragma once

#include <functional>
#include <vector>

#include "base/json.h"
#include "study/run/run_settings.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Values at points of the file's units [N]; points without a value are left out.
struct CheapTable {
  std::vector<std::vector<double>> points;
  std::vector<double> values;
};
Json to_json(const CheapTable& table);
CheapTable cheap_table_from(const Json& json);

// Evaluated over the feasible part of the ranges, in threads of this process. `pause` is asked between
// evaluations and may throw.
CheapTable cheap_table(const StudySpec& spec, const RunSettings& settings,
                       const std::function<bool(const std::vector<double>&)>& feasible,
                       const std::function<void()>& pause);

// A Gaussian process through the table; empty where it has too few points to be one.
std::function<double(const std::vector<double>&)> cheap_response(const StudySpec& spec,
                                                                 const CheapTable& table);

}  // namespace icebow
