// `icebow calibrate --cycle`: patch tests of the edge of a study's ice, and what the breaking cycle's other
// rules say of the same edges.
#pragma once

#include "cli/study_choice.h"

namespace icebow {

// Returns the exit code.
int calibrate_cycle(const ChosenDesign& chosen, bool as_json);

}  // namespace icebow
