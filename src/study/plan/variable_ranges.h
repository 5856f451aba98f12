// The ranges of a study's variables, and which designs lie within them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/evaluate/evaluation.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Whether every variable has a value there, within its range.
bool is_within(const std::vector<Variable>& variables, const std::map<std::string, double>& parameters);

// A sentence for each range that does not hold the file's own value.
std::vector<std::string> notes_on_ranges(const StudySpec& spec);

// Whether some design within the ranges is infeasible, and none is anything else. A study without variables
// is judged by all its designs.
bool nothing_feasible(const StudySpec& spec, const std::vector<Evaluation>& evaluations);

}  // namespace icebow
