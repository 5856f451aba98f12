// The part of a study file that names designs and evaluators.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Each notes its mistakes; what they return is to be used only where they added none.
std::vector<NamedDesign> parse_designs(const Json& document, Mistakes& mistakes);
void parse_evaluators(const Json& document, StudySpec& spec, Mistakes& mistakes);

// Mistakes of the case after a change that the case before did not have.
Mistakes new_case_mistakes(const Json& before, const Json& after);

}  // namespace icebow
