// A result of the breaking cycle for people.
#pragma once

#include <string>

#include "study/evaluate/cycle_run.h"

namespace icebow {

std::string cycle_text(const CycleOutcome& outcome, const Case& c, const std::string& design);

}  // namespace icebow
