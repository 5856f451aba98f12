// The smallest ship-ice run: a box with a sloping front in a sheet of some thousand particles.
#pragma once

#include <cmath>

#include "geometry/quad_mesh.h"
#include "solver/model/scenario.h"

namespace icebow {

// Six quads in the hull frame, front plane at `stem` rad to the horizontal through (0, y, 0).
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

inline QuadMesh tiny_hull() {
  return sloping_box(0.45, 0.2, 0.08, 0.15, 1.2);
}

// `length` and `advance` in m.
inline Scenario tiny_run(double length, double advance) {
  Scenario s;
  s.ice = {0.04, 826.6, 52e6, 0.33, 0.0, 60e3};
  s.sheet = {length, 0.56, FixedEdges::sides};
  s.numerics.dx = 0.02;
  s.numerics.friction = 0.1;
  s.V = 0.5;
  s.advance = advance;
  s.steady_from = 0.03;
  return s;
}

}  // namespace icebow
