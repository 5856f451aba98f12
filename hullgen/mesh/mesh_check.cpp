#include "hullgen/mesh/mesh_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <limits>

#include "base/text.h"
#include "geometry/triangles.h"
#include "hullgen/mesh/mesh_edges.h"

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::vector<int> corners(const QuadMesh& mesh, std::size_t quad) {
  const auto& q = mesh.quads[quad];
  return {q.begin(), q.begin() + (mesh.is_triangle(quad) ? 3 : 4)};
}

// Why it cannot be looked at further; empty where it can.
std::string implausible(const QuadMesh& mesh) {
  if (mesh.quads.empty()) return "it has no panels";
  const int n = static_cast<int>(mesh.points.size());
  const bool indices = std::all_of(mesh.quads.begin(), mesh.quads.end(), [n](const auto& q) {
    return std::all_of(q.begin(), q.end(), [n](int corner) { return corner >= 0 && corner < n; });
  });
  if (!indices) return "a panel has a corner beyond the last point";
  const bool finite =
      std::all_of(mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return p.allFinite(); });
  return finite ? "" : "a point has a coordinate that is no finite number";
}

std::vector<std::vector<int>> polygons(const QuadMesh& mesh) {
  std::vector<std::vector<int>> result;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) result.push_back(corners(mesh, q));
  return result;
}

// Oriented and manifold, each corner of a polygon another point.
template <class Polygon>
bool is_polygon_mesh(const std::vector<Polygon>& polygons) {
  return std::all_of(polygons.begin(), polygons.end(),
                     [](Polygon p) {
                       std::sort(p.begin(), p.end());
                       return std::adjacent_find(p.begin(), p.end()) == p.end();
                     }) &&
         PMP::is_polygon_soup_a_polygon_mesh(polygons);
}

// The facets as panels: a diagonal may run along another panel's edge.
std::string flaw_of_facets(const QuadMesh& mesh, const std::vector<std::array<int, 3>>& facets) {
  QuadMesh split;
  split.points = mesh.points;
  for (const auto& [a, b, c] : facets) split.quads.push_back({a, b, c, c});
  return flaw_of_surface(split);
}

SurfaceMesh surface_mesh(const QuadMesh& mesh, const std::vector<std::array<int, 3>>& facets) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& p : mesh.points) points.emplace_back(p.x(), p.y(), p.z());
  SurfaceMesh result;
  PMP::polygon_soup_to_polygon_mesh(points, facets, result);
  return result;
}

Vec3 centre(const SurfaceMesh& surface, SurfaceMesh::Face_index face) {
  Vec3 sum = Vec3::Zero();
  for (const auto v : surface.vertices_around_face(surface.halfedge(face))) {
    const Kernel::Point_3& p = surface.point(v);
    sum += Vec3(p.x(), p.y(), p.z()) / 3.0;
  }
  return sum;
}

void find_intersections(const SurfaceMesh& surface, MeshCheck& check) {
  check.self_intersecting = PMP::does_self_intersect(surface);
  if (!check.self_intersecting) return;
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  PMP::self_intersections(surface, std::back_inserter(pairs));
  check.intersections = static_cast<int>(pairs.size());
  check.intersection = 0.5 * (centre(surface, pairs.front().first) + centre(surface, pairs.front().second));
}

struct Shape {
  double warp = 0.0, aspect = 1.0;
};

Shape shape(const QuadMesh& mesh, std::size_t quad) {
  const auto c = corners(mesh, quad);
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity(), perimeter = 0.0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const double edge = (mesh.points[c[(k + 1) % c.size()]] - mesh.points[c[k]]).norm();
    longest = std::max(longest, edge);
    shortest = std::min(shortest, edge);
    perimeter += edge;
  }
  Shape result{0.0, longest / shortest};
  if (c.size() == 3) return result;
  // The corners of a quad lie alternately above and below the plane of both diagonals' directions through its
  // centre.
  const Vec3 &p0 = mesh.points[c[0]], &p1 = mesh.points[c[1]], &p2 = mesh.points[c[2]],
             &p3 = mesh.points[c[3]];
  const Vec3 normal = (p2 - p0).cross(p3 - p1).normalized();
  result.warp = std::abs(normal.dot(p0 + p2 - p1 - p3)) / 4.0 / (perimeter / 4.0);
  return result;
}

}  // namespace

std::string MeshCheck::reason() const {
  if (!valid_polygon_mesh) return "the mesh is not an oriented manifold surface: " + flaw;
  if (!closed) return "the mesh is not closed";
  if (self_intersecting)
    return text("the mesh intersects itself: %d pairs of triangles cross, one at (%g, %g, %g) m",
                intersections, intersection.x(), intersection.y(), intersection.z());
  if (!outward) return "the mesh does not bound a volume with its normals outward";
  return "";
}

MeshCheck check_mesh(const QuadMesh& mesh) {
  MeshCheck check;
  check.points = static_cast<int>(mesh.points.size());
  check.flaw = implausible(mesh);
  if (!check.flaw.empty()) return check;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const Shape s = shape(mesh, q);
    check.max_warp = std::max(check.max_warp, s.warp);
    check.max_aspect = std::max(check.max_aspect, s.aspect);
    if (mesh.patch[q] == Patch::bow || mesh.patch[q] == Patch::reamer)
      check.max_bow_aspect = std::max(check.max_bow_aspect, s.aspect);
    ++(mesh.is_triangle(q) ? check.triangles : check.quads);
  }
  check.volume = enclosed_volume(mesh);

  const std::vector<std::array<int, 3>> facets = triangles(mesh);
  check.valid_polygon_mesh = is_polygon_mesh(polygons(mesh)) && is_polygon_mesh(facets);
  if (!check.valid_polygon_mesh) {
    check.flaw = flaw_of_surface(mesh);
    if (check.flaw.empty()) check.flaw = flaw_of_facets(mesh, facets);
    return check;
  }
  const SurfaceMesh surface = surface_mesh(mesh, facets);
  check.closed = CGAL::is_closed(surface);
  find_intersections(surface, check);
  check.outward = check.closed && !check.self_intersecting && PMP::does_bound_a_volume(surface) &&
                  PMP::is_outward_oriented(surface);
  return check;
}

}  // namespace icebow
