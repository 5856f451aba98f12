// The section "constraints" of a study file: what a result must keep to.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Notes its mistakes: no number of a result that the study's evaluators have, bounds that are none.
void parse_constraints(const Json& document, StudySpec& spec, Mistakes& mistakes);

// What the study lacks for the number at a pointer of its results; empty where it is there.
std::string lacking_number(const StudySpec& spec, const std::string& at);

}  // namespace icebow
