#include "geometry/hull_distance.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

// Both searches end here, so that they agree to the last bit.
ClosestPoint oriented(const TriangleSurface& surface, int triangle, const TrianglePoint& at, const Vec3& p) {
  ClosestPoint result;
  result.point = at.point;
  result.normal = surface.normal(triangle, at.feature);
  const double distance = std::sqrt(at.squared_distance);
  result.signed_distance = (p - at.point).dot(result.normal) < 0.0 ? -distance : distance;
  result.quad = surface.quad(triangle);
  return result;
}

Box common(const Box& a, const Box& b) {
  return {a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)};
}

}  // namespace

ClosestPoint closest_brute_force(const TriangleSurface& surface, const Vec3& p) {
  int nearest = 0;
  TrianglePoint best = closest_on_triangle(surface.corners(0), p);
  for (std::size_t t = 1; t < surface.size(); ++t) {
    const TrianglePoint at = closest_on_triangle(surface.corners(t), p);
    if (at.squared_distance < best.squared_distance) best = at, nearest = static_cast<int>(t);
  }
  return oriented(surface, nearest, best, p);
}

HullDistance::HullDistance(const QuadMesh& mesh, const Box& region)
    : surface_(mesh),
      tree_(surface_),
      cells_(make_hull_cells(surface_, tree_, common(bounding_box(mesh), region))) {}

ClosestPoint HullDistance::closest(const Vec3& p) const {
  const Eigen::Vector3f f = p.cast<float>();
  const NearestTriangle nearest = cells_.closest(tree_, cells_.kind_at(f.x(), f.y(), f.z()), p);
  return oriented(surface_, nearest.triangle, nearest.at, p);
}

// A slot near a point, or -1.
int HullDistance::seed(const Vec3& p) const {
  const Eigen::Vector3f f = p.cast<float>();
  const std::int32_t kind = cells_.kind_at(f.x(), f.y(), f.z());
  if (kind < 0) return ~kind;
  if (kind == 0 || cells_.surface[kind - 1].count == 0) return -1;
  return cells_.candidates[cells_.surface[kind - 1].first].slot;
}

// A point that moves by w is nearer to one triangle by w at most, and further from another by w at most.
ClosestPoint HullDistance::closest(const Vec3& p, Known& known) const {
  constexpr double rounding = 1.0 - 1e-5;
  if (known.rest <= 0.0F) {
    double second = 0.0;
    const NearestTriangle nearest = tree_.closest_two(p, seed(p), second);
    const double gap = 0.5 * rounding * (std::sqrt(second) - std::sqrt(nearest.at.squared_distance));
    const float cell = cells_.grid.size;
    // On an edge both of its triangles are as near.
    known = gap > 0.01 * cell ? Known{nearest.slot, static_cast<float>(gap)} : Known{-1, 0.1F * cell};
    return oriented(surface_, nearest.triangle, nearest.at, p);
  }
  if (known.slot < 0) return closest(p);
  return oriented(surface_, tree_.triangle(known.slot), tree_.closest_of(known.slot, p), p);
}

}  // namespace icebow
