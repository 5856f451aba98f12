#include "hullgen/mesh/ring_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/utility.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Ring = std::vector<int>;
using Triangles = std::vector<std::array<int, 3>>;
using Shadow = std::vector<Kernel::Point_2>;
using Plane = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
                                                 CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

Point point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

bool has_area(const std::vector<Vec3>& p, const std::array<int, 3>& t) {
  const Vec3 a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
  return a.cross(b).norm() > 1e-12 * std::max(a.squaredNorm(), b.squaredNorm());
}

// Of the ring on its mean plane, which it goes round to the left; none where it has no area, or one beyond
// numbers.
Shadow shadow_of(const std::vector<Vec3>& points, const Ring& ring) {
  Vec3 normal = Vec3::Zero();  // Newell's
  for (std::size_t k = 0; k < ring.size(); ++k)
    normal += points[ring[k]].cross(points[ring[(k + 1) % ring.size()]]);
  if (!(normal.norm() > 0.0) || !std::isfinite(normal.norm())) return {};
  const Vec3 u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  Shadow shadow;
  for (const int k : ring) shadow.emplace_back(u.dot(points[k]), v.dot(points[k]));
  return shadow;
}

// The faces outside the ring: what is reached from infinity without crossing one of its edges.
std::set<Plane::Face_handle> outside(const Plane& plane) {
  std::set<Plane::Face_handle> reached = {plane.infinite_face()};
  std::vector<Plane::Face_handle> next = {plane.infinite_face()};
  while (!next.empty()) {
    const Plane::Face_handle face = next.back();
    next.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!face->is_constrained(k) && reached.insert(face->neighbor(k)).second)
        next.push_back(face->neighbor(k));
  }
  return reached;
}

// By the shadow of the ring on its mean plane. One shadow is looked at and triangulated: CGAL has no answer,
// and no end, for one that crosses or touches itself, and another plane might show such a one.
Triangles by_shadow(const std::vector<Vec3>& points, const Ring& ring) {
  const Shadow shadow = shadow_of(points, ring);
  if (shadow.empty() || !CGAL::is_simple_2(shadow.begin(), shadow.end(), Kernel())) return {};
  Plane plane;
  std::vector<Plane::Vertex_handle> corners;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    corners.push_back(plane.insert(shadow[k]));
    corners.back()->info() = ring[k];
  }
  for (std::size_t k = 0; k < ring.size(); ++k)
    plane.insert_constraint(corners[k], corners[(k + 1) % ring.size()]);
  const std::set<Plane::Face_handle> outer = outside(plane);
  Triangles result;
  for (const Plane::Face_handle f : plane.finite_face_handles())
    if (!outer.count(f)) result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

Triangles by_least_turn(const std::vector<Vec3>& points, const Ring& ring) {
  std::vector<Point> line;
  for (const int k : ring) line.push_back(point(points[k]));
  std::vector<CGAL::Triple<int, int, int>> found;
  PMP::triangulate_hole_polyline(line, std::back_inserter(found));
  Triangles result;
  for (const auto& t : found) result.push_back({ring[t.first], ring[t.second], ring[t.third]});
  return result;
}

}  // namespace

Triangles ring_triangles(const std::vector<Vec3>& points, const Ring& ring) {
  if (ring.size() < 3) return {};
  if (ring.size() == 3) return {{ring[0], ring[1], ring[2]}};
  const auto good = [&](const Triangles& all) {
    return all.size() + 2 == ring.size() &&
           std::all_of(all.begin(), all.end(), [&](const auto& t) { return has_area(points, t); });
  };
  Triangles flat = by_shadow(points, ring);
  if (good(flat)) return flat;
  Triangles curved = by_least_turn(points, ring);
  if (good(curved)) return curved;
  return flat.size() + 2 == ring.size() ? flat : curved;
}

}  // namespace icebow
