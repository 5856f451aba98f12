#include "geometry/hull_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace icebow {
namespace {

// Distances that points may move by are this part of what was found.
constexpr double rounding = 1.0 - 1e-5;

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

NearestTriangle HullDistance::nearest(const Vec3& p) const {
  const Eigen::Vector3f f = p.cast<float>();
  return cells_.closest(tree_, cells_.kind_at(f.x(), f.y(), f.z()), p);
}

ClosestPoint HullDistance::closest(const Vec3& p) const {
  const NearestTriangle found = nearest(p);
  return oriented(surface_, found.triangle, found.at, p);
}

// A point that moves by w is nearer to one triangle by w at most, and further from another by w at most.
void HullDistance::keep(const Vec3& p, double distance, Known& known) const {
  constexpr double of_a_cell = 0.3;  // a longer way needs more triangles
  const double way = of_a_cell * cells_.grid.size;
  std::vector<TriangleTree::Near> near;
  tree_.within(p, distance + 2.0 * way, near);
  known.rest = static_cast<float>(rounding * way);
  known.lead = 0.0F;
  known.count = near.size() <= Known::most ? static_cast<std::int32_t>(near.size()) : 0;
  for (int n = 0; n < known.count; ++n) known.slot[n] = near[n].slot;
}

// The nearest of the known triangles, which are put in order, with the lead that the first have over the
// others.
NearestTriangle HullDistance::compete(const Vec3& p, Known& known) const {
  constexpr double distances_differ = 1e-9;  // by more than their rounding [m]
  constexpr double worth_a_leader = 0.1;     // of the way that is left
  std::array<std::pair<double, std::int32_t>, Known::most> by_distance;
  NearestTriangle best = TriangleTree::no_triangle();
  for (int n = 0; n < known.count; ++n)
    by_distance[n] = {std::sqrt(tree_.improve(known.slot[n], p, best)), known.slot[n]};
  std::sort(by_distance.begin(), by_distance.begin() + known.count);
  for (int n = 0; n < known.count; ++n) known.slot[n] = by_distance[n].second;
  for (known.leaders = 1; known.leaders < known.count; ++known.leaders) {
    const double behind = by_distance[known.leaders].first - by_distance[0].first;
    known.lead = static_cast<float>(rounding * 0.5 * behind - distances_differ);
    if (known.lead > worth_a_leader * known.rest) return best;
  }
  known.lead = known.rest;
  return best;
}

ClosestPoint HullDistance::closest(const Vec3& p, Known& known) const {
  NearestTriangle best = TriangleTree::no_triangle();
  if (known.rest > 0.0F && known.count > 0) {
    if (known.lead > 0.0F) {
      for (int n = 0; n < known.leaders; ++n) tree_.improve(known.slot[n], p, best);
    } else {
      best = compete(p, known);
    }
  } else {
    best = nearest(p);
    if (!(known.rest > 0.0F)) keep(p, std::sqrt(best.at.squared_distance), known);
  }
  return oriented(surface_, best.triangle, best.at, p);
}

}  // namespace icebow
