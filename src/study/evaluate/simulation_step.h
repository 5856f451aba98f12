// The step of evaluate() that simulates a design, or one of its scenarios.
#pragma once

#include "study/evaluate/design_work.h"

namespace icebow {

// Adds "metrics", "process", "simulation", "profile" and files to the result. Throws RuntimeError for what
// the machine does.
StepEnd sail(DesignWork& work);

}  // namespace icebow
