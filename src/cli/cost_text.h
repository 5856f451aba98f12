// What a study takes, in words: `icebow check --cost`.
#pragma once

#include <string>

#include "study/plan/design_space.h"
#include "study/spec/study_spec.h"

namespace icebow {

// By a measurement of some seconds of the file's own design.
std::string cost_text(const StudySpec& spec, const StudyPlan& plan);
// Of this design alone.
std::string cost_text(const StudySpec& spec, const Design& design);

}  // namespace icebow
