// Why a run that came apart did: the likely cause, read off the place where the ice is fastest.
#pragma once

#include <string>

#include "solver/step/stepper.h"

namespace icebow {

// Why the particle at place p of this rank's fields runs away: a time step above `dt_limit` (0 = unknown),
// contact with the hull, or ice that is squeezed or stretched far beyond what the limit was computed for.
std::string likely_cause(const Stepper& stepper, std::size_t p, double dt_limit);

}  // namespace icebow
