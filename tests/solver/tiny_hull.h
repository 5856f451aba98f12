// A box with a sloping front, the simplest icebreaker: six quads in the hull frame.
#pragma once

#include <cmath>

#include "base/quad_mesh.h"

namespace icebow {

// Front plane at `stem` rad to the horizontal through (0, y, 0).
inline QuadMesh sloping_box(double stem, double B, double above, double below, double length) {
  const double cot = 1.0 / std::tan(stem);
  QuadMesh m;
  for (double side : {-1.0, 1.0}) {
    const double y = 0.5 * side * B;
    m.points.emplace_back(above * cot, y, above);    // 0, 4: front top
    m.points.emplace_back(-below * cot, y, -below);  // 1, 5: front bottom
    m.points.emplace_back(-length, y, -below);       // 2, 6: back bottom
    m.points.emplace_back(-length, y, above);        // 3, 7: back top
  }
  m.quads = {{0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}, {0, 1, 2, 3}, {4, 7, 6, 5}};
  for (auto& q : m.quads) std::swap(q[1], q[3]);
  m.patch.assign(6, Patch::other);
  return m;
}

}  // namespace icebow
