// The blocks of ice that tests try.
#pragma once

#include "solver/ice/ice_block.h"

namespace icebow {

inline Scenario block_scenario(int nx, int ny, int nz, double dx = 0.013) {
  Scenario s;
  s.ice = {nz * dx, 826.6, 52e6, 0.33, 0.0052, 0.0};
  s.sheet = {nx * dx, ny * dx, FixedEdges::none};
  s.numerics.dx = dx;
  s.V = 0.4;
  return s;
}

}  // namespace icebow
