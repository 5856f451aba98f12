// The section "constraints" of a study file: what a result must keep to.
#pragma once

#include <string>
#include <vector>

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Notes its mistakes: no number of a result that the study's evaluators have, bounds that are none.
void parse_constraints(const Json& document, StudySpec& spec, Mistakes& mistakes);

// Pointers of the numbers of a result, but for those that programs print and those below /cycle/process.
// Which margins a bow has depends on its family.
const std::vector<std::string>& numbers_of_results();

// What the study lacks for the number at a pointer of its results, or that no result has it; empty where it
// is there.
std::string lacking_number(const StudySpec& spec, const std::string& at);

}  // namespace icebow
