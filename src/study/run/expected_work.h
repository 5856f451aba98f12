// How much computing a design is, as far as its description tells: to begin with the longest.
#pragma once

#include <vector>

#include "study/plan/design_space.h"

namespace icebow {

// Particles times steps of its simulation, up to a factor that all designs share; 0 without a simulation.
double expected_work(const Design& design);

// The longest first, those alike in their order: designs that run side by side end together [Graham1969].
std::vector<PlannedDesign> longest_first(std::vector<PlannedDesign> designs);

}  // namespace icebow
