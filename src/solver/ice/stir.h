// A start of its own for each repeat of a run.
#pragma once

#include <cstdint>

#include "solver/ice/sheet.h"

namespace icebow {

// Speeds of the stirred ice, over the ship's: uniformly random between minus and plus this, each component.
constexpr double stirring = 1e-3;

// Gives the ice at rest random velocities. A function of the seed and of the particle's place in the sheet:
// the same on any number of ranks. Seed 0: leaves it at rest. docs/theory.md, "Repeats".
void stir(IceSheet& sheet, std::uint64_t seed, double ship_speed);

}  // namespace icebow
