// Bare panels that face ahead, with known geometry.
#pragma once

#include <cmath>

#include "cycle/cycle_input.h"
#include "geometry/quad_mesh.h"

namespace icebow::cycle {

// A quad of four corners; turned so that it faces ahead.
inline void add_panel(QuadMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int n = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {a, b, c, d});
  if ((b - a).cross(c - a).x() > 0.0)
    mesh.quads.push_back({n, n + 1, n + 2, n + 3});
  else
    mesh.quads.push_back({n, n + 3, n + 2, n + 1});
  mesh.patch.push_back(Patch::bow);
}

// A plane across the course, y from -width/2 to width/2, z from -deep to deep; it slopes at `slope` from the
// horizontal, foremost at its upper edge, with its waterline at x = 0. 90 deg: a wall.
inline QuadMesh plate(double width, double slope, double deep) {
  QuadMesh mesh;
  const double x = deep / std::tan(slope), y = 0.5 * width;
  add_panel(mesh, {-x, -y, -deep}, {-x, y, -deep}, {x, y, deep}, {x, -y, deep});
  return mesh;
}

// Two planes that meet in a stem of the slope `stem`; waterlines at `angle` to the centre plane.
inline QuadMesh sharp_stem(double half_beam, double stem, double angle, double deep) {
  QuadMesh mesh;
  const double x = deep / std::tan(stem), aft = half_beam / std::tan(angle);
  for (double side : {-1.0, 1.0})
    add_panel(mesh, {-x, 0.0, -deep}, {x, 0.0, deep}, {x - aft, side * half_beam, deep},
              {-x - aft, side * half_beam, -deep});
  return mesh;
}

inline QuadMesh mapped(QuadMesh mesh, const Vec3& factor, const Vec3& shift) {
  for (Vec3& p : mesh.points) p = p.cwiseProduct(factor) + shift;
  if (factor.prod() < 0.0)
    for (auto& q : mesh.quads) std::swap(q[1], q[3]);
  return mesh;
}

// The ice of the published case at full scale.
inline Ice published_ice() {
  Ice ice;
  ice.h = 1.0, ice.rho = 826.6, ice.E = 1.3e9, ice.nu = 0.33, ice.sigma_f = 863e3, ice.p_c = 2.6e6;
  ice.friction = 0.1, ice.rho_w = 1000.0;
  return ice;
}

}  // namespace icebow::cycle
