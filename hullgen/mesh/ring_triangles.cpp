#include "hullgen/mesh/ring_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Ring = std::vector<int>;
using Triangles = std::vector<std::array<int, 3>>;

Point point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

bool has_area(const std::vector<Vec3>& p, const std::array<int, 3>& t) {
  const Vec3 a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
  return a.cross(b).norm() > 1e-12 * std::max(a.squaredNorm(), b.squaredNorm());
}

// CGAL's triangulation of a shadow whose edges cross is undefined.
bool shadow_is_simple(const std::vector<Vec3>& points, const Ring& ring) {
  Vec3 normal = Vec3::Zero();  // Newell's
  for (std::size_t k = 0; k < ring.size(); ++k)
    normal += points[ring[k]].cross(points[ring[(k + 1) % ring.size()]]);
  if (!(normal.norm() > 0.0)) return false;
  const Vec3 u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  std::vector<Kernel::Point_2> shadow;
  for (const int k : ring) shadow.emplace_back(u.dot(points[k]), v.dot(points[k]));
  return CGAL::is_simple_2(shadow.begin(), shadow.end(), Kernel());
}

// By the shadow of the ring on its mean plane.
Triangles by_shadow(const std::vector<Vec3>& points, const Ring& ring) {
  if (!shadow_is_simple(points, ring)) return {};
  CGAL::Surface_mesh<Point> surface;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> vertices;
  for (const int k : ring) vertices.push_back(surface.add_vertex(point(points[k])));
  const auto face = surface.add_face(vertices);
  if (face == surface.null_face() || !PMP::triangulate_face(face, surface)) return {};
  Triangles result;
  for (const auto f : surface.faces()) {
    Ring corners;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) {
      if (corners.size() == 3) return {};  // of a ring that touches itself CGAL makes faces without end
      // Where the shadow's edges cross, the crossing is a corner that the ring does not have.
      if (static_cast<std::size_t>(v) >= ring.size()) return {};
      corners.push_back(ring[static_cast<std::size_t>(v)]);
    }
    if (corners.size() != 3) return {};
    result.push_back({corners[0], corners[1], corners[2]});
  }
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
