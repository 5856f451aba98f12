// The particles of a sheet, as pictures and ParaView files take them.
#pragma once

#include <cstdint>
#include <vector>

namespace icebow {

// Particles of the sheet, any order. Model scale, metres; x, y, z current positions.
struct IceCloud {
  std::vector<float> x, y, z;
  std::vector<float> ux, uy, uz;    // displacement
  std::vector<float> vx, vy, vz;    // velocity; empty where nobody asks for it
  std::vector<float> damage;        // broken / initial bonds, 0..1
  std::vector<std::int32_t> piece;  // 0 = standing sheet, > 0 = floe number, -1 = crushed (small pieces)
  double dx = 0.0;                  //!< lattice spacing [m]
};

}  // namespace icebow
