// The section "scenarios" of a study file: conditions that each design is judged over.
#pragma once

#include <functional>

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// parse_case(), which reads the scenarios of a document and whose cases they are.
using CaseReader = std::function<Case(const Json& document, Mistakes& mistakes)>;

// Fills c.scenarios, and c.by_worst as /ranking/over_scenarios says. Notes its mistakes; a mistake that the
// file has without the scenario is not noted again under /scenarios/K/set.
void read_scenarios(const Json& document, const CaseReader& reader, Case& c, Mistakes& mistakes);

// What does not go together with scenarios: variables that belong to the conditions.
void check_scenarios(const StudySpec& spec, Mistakes& mistakes);

// The sections that a scenario may set.
const std::vector<std::string>& condition_sections();

}  // namespace icebow
