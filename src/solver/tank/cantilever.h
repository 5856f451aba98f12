// What a tank makes of a cantilever's load: equation (29) of docs/theory.md.
#pragma once

#include "solver/tank/beam_test.h"
#include "solver/tank/tearing.h"

namespace icebow {

constexpr int beam_length = 7, beam_width = 2;  // over the thickness

struct Cantilever {
  double length, width, thickness;  // root to load [m]; [m]; [m]
  double nu;
};

// Stiffness: force over deflection of the tip, unbroken [N/m].
BeamTest beam_test(const Cantilever& cantilever, double stiffness, const Failure& failure);

}  // namespace icebow
