// The particles of a sheet, as pictures and ParaView files take them.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/model/cracked_place.h"

namespace icebow {

// Particles of the sheet, any order. Model scale, metres; x, y, z current positions.
struct IceCloud {
  std::vector<float> x, y, z;
  std::vector<float> ux, uy, uz;    // displacement
  std::vector<float> vx, vy, vz;    // velocity; empty where nobody asks for it
  std::vector<float> damage;        // broken / initial bonds, 0..1
  std::vector<std::int32_t> piece;  // 0 = standing sheet, > 0 = floe number, -1 = crushed (small pieces)
  // Crack that the particle's column belongs to: 0 none, else 1 + CrackKind; empty where nobody asks.
  std::vector<std::int32_t> crack;
  double dx = 0.0;  //!< lattice spacing [m]
};

// Fills `crack`.
void mark_cracks(IceCloud& ice, const std::vector<CrackedPlace>& places);

}  // namespace icebow
