// Number of the cell of a uniform grid that a point lies in, cheap enough to ask for every particle.
#pragma once

#include <algorithm>
#include <cstdint>

namespace icebow {

struct CellGrid {
  // Cell numbers are computed in floats, which are exact up to here.
  static constexpr std::int32_t most_cells = 4'000'000;

  float lower[3] = {0, 0, 0};  //!< [m]
  float size = 1;              //!< edge of a cell [m]
  float per_size = 1;          //!< 1 / size
  float n[3] = {0, 0, 0};      // cells along x, y, z; whole numbers

  std::int32_t cells() const { return static_cast<std::int32_t>(n[0] * n[1] * n[2]); }

  // 0 outside the grid and for NaN, else 1 + ix + nx (iy + ny iz). Neighbouring cells may be mistaken for
  // each other within 1e-3 of a cell of their common side. No branches: a loop over points is vectorised.
  std::int32_t cell(float x, float y, float z) const {
    const float fx = (x - lower[0]) * per_size, fy = (y - lower[1]) * per_size,
                fz = (z - lower[2]) * per_size;
    const bool inside = (fx >= 0.0f) & (fy >= 0.0f) & (fz >= 0.0f) & (fx < n[0]) & (fy < n[1]) & (fz < n[2]);
    const float number = whole(fx, n[0]) + n[0] * (whole(fy, n[1]) + n[1] * whole(fz, n[2]));
    return inside ? 1 + static_cast<std::int32_t>(number) : 0;
  }

 private:
  // The clamp makes the conversion defined for points outside the grid.
  static float whole(float f, float n) {
    return static_cast<float>(static_cast<std::int32_t>(std::max(0.0f, std::min(f, n))));
  }
};

static_assert(CellGrid::most_cells < (1 << 24), "every cell number must be a float");

}  // namespace icebow
