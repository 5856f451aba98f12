// The part of a study file that describes one ship in one ice.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Notes every mistake; what it returns is to be used only where it added none.
Case parse_case(const Json& document, Mistakes& mistakes);

// Only what describes one ship in one ice (scale, bow, ice, water, sheet, operation, solver, output): the
// document of a design, its overrides applied. Methods, designs and execution in it are not looked at. Throws
// likewise.
Case read_case(const Json& document, const std::string& name);

}  // namespace icebow
