#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>

namespace icebow::shapes {
namespace {

void add_quad(QuadMesh& mesh, const std::array<Vec3, 4>& corners) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.quads.push_back({first, first + 1, first + 2, first + 3});
  mesh.patch.push_back(Patch::other);
}

// The side of a unit cell towards +axis or -axis: its four corners counter-clockwise seen from outside.
std::array<std::array<int, 3>, 4> side(int axis, bool upper) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<std::array<int, 3>, 4> corners{};
  const int steps[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) {
    const auto& step = steps[upper ? k : 3 - k];
    corners[k][axis] = upper ? 1 : 0;
    corners[k][u] = step[0];
    corners[k][v] = step[1];
  }
  return corners;
}

}  // namespace

QuadMesh mapped_cube(const std::array<int, 3>& n, const Map& map) {
  QuadMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int i = 0; i < n[u]; ++i)
        for (int j = 0; j < n[v]; ++j) {
          std::array<Vec3, 4> corners;
          const auto steps = side(axis, upper);
          for (int k = 0; k < 4; ++k) {
            Vec3 p;
            p[axis] = upper ? 1.0 : 0.0;
            p[u] = static_cast<double>(i + steps[k][u]) / n[u];
            p[v] = static_cast<double>(j + steps[k][v]) / n[v];
            corners[k] = map(p);
          }
          add_quad(mesh, corners);
        }
    }
  return mesh;
}

QuadMesh box(const Vec3& lower, const Vec3& upper, const std::array<int, 3>& n) {
  return mapped_cube(n, [&](const Vec3& p) -> Vec3 { return lower + p.cwiseProduct(upper - lower); });
}

QuadMesh cubes(const std::set<std::array<int, 3>>& cells) {
  QuadMesh mesh;
  for (const auto& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        std::array<int, 3> neighbour = cell;
        neighbour[axis] += upper ? 1 : -1;
        if (cells.count(neighbour)) continue;
        std::array<Vec3, 4> corners;
        const auto steps = side(axis, upper);
        for (int k = 0; k < 4; ++k)
          corners[k] = Vec3(cell[0] + steps[k][0], cell[1] + steps[k][1], cell[2] + steps[k][2]);
        add_quad(mesh, corners);
      }
  return mesh;
}

QuadMesh hull(double length, double beam, double depth, int quads) {
  const double area = 2.0 * (length * beam + length * depth + beam * depth), size = std::sqrt(area / quads);
  const auto steps = [&](double extent) { return std::max(2, static_cast<int>(std::lround(extent / size))); };
  const double bow = 1.4 * beam, cot_stem = 2.2;
  return mapped_cube({steps(length), steps(beam), steps(depth)}, [&](const Vec3& p) -> Vec3 {
    const double aft = (1.0 - p.x()) * length, z = (p.z() - 0.6) * depth;
    const double fullness = 1.0 - std::pow(1.0 - std::min(1.0, aft / bow), 2);
    const double half_breadth = 0.5 * beam * fullness * (0.8 + 0.2 * p.z());
    // The rake of the stem dies out along the bow.
    const double rake = cot_stem * z * (1.0 - std::min(1.0, aft / bow));
    return {rake - aft, (2.0 * p.y() - 1.0) * half_breadth, z};
  });
}

QuadMesh triangulated(const QuadMesh& mesh) {
  QuadMesh result;
  result.points = mesh.points;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const auto& v = mesh.quads[q];
    result.quads.push_back({v[0], v[1], v[2], v[2]});
    result.quads.push_back({v[0], v[2], v[3], v[3]});
    result.patch.insert(result.patch.end(), 2, mesh.patch[q]);
  }
  return result;
}

}  // namespace icebow::shapes
