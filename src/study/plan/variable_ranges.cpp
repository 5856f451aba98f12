#include "study/plan/variable_ranges.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "study/spec/spec_hints.h"

namespace icebow {

bool is_within(const std::vector<Variable>& variables, const std::map<std::string, double>& parameters) {
  return std::all_of(variables.begin(), variables.end(), [&](const Variable& v) {
    if (!v.words.empty()) return true;
    const auto found = parameters.find(v.pointer);
    return found != parameters.end() && found->second >= v.lower && found->second <= v.upper;
  });
}

std::vector<std::string> notes_on_ranges(const StudySpec& spec) {
  std::vector<std::string> notes;
  if (spec.method.type == MethodType::table) return notes;
  for (const Variable& v : spec.method.variables) {
    const double value = number_at(spec.document, v.pointer);
    if (!v.values.empty() || !std::isfinite(value) || (value >= v.lower && value <= v.upper)) continue;
    notes.push_back(v.pointer + " is " + brief(value) + " in the file, outside its range of " +
                    brief(v.lower) + " to " + brief(v.upper) + ": the baseline is no point of the method" +
                    (spec.method.type == MethodType::optimise
                         ? ", and the search starts at " + brief(std::clamp(value, v.lower, v.upper))
                         : ""));
  }
  return notes;
}

bool nothing_feasible(const StudySpec& spec, const std::vector<Evaluation>& evaluations) {
  bool any = false;
  for (const Evaluation& e : evaluations) {
    if (!is_within(spec.method.variables, e.parameters)) continue;
    if (e.status != EvaluationStatus::infeasible) return false;
    any = true;
  }
  return any;
}

}  // namespace icebow
