#include "hullgen/mesh/mesh_wrap.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/triangles.h"

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Vec3 vec(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

void append(QuadMesh& mesh, const Surface& surface) {
  const int first = static_cast<int>(mesh.points.size());
  std::map<Surface::Vertex_index, int> number;
  for (const auto v : surface.vertices()) {
    number[v] = first + static_cast<int>(number.size());
    mesh.points.push_back(vec(surface.point(v)));
  }
  for (const auto f : surface.faces()) {
    std::array<int, 4> q{};
    int k = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) q[k++] = number[v];
    q[3] = q[2];
    mesh.quads.push_back(q);
    mesh.patch.push_back(Patch::other);
  }
}

}  // namespace

QuadMesh wrapped(const QuadMesh& mesh, double fineness, Wrapping& wrapping) {
  std::vector<Point> points;
  for (const Vec3& p : mesh.points) points.emplace_back(p.x(), p.y(), p.z());
  const std::vector<std::array<int, 3>> facets = triangles(mesh);
  Surface wrap;
  CGAL::alpha_wrap_3(points, facets, fineness, fineness / 50.0, wrap);
  Triangles original;
  for (const auto& t : facets) original.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
  Tree tree(original.begin(), original.end());
  Surface on_mesh = wrap;
  for (const auto v : on_mesh.vertices()) on_mesh.point(v) = tree.closest_point(on_mesh.point(v));
  if (!PMP::does_self_intersect(on_mesh)) wrap = std::move(on_mesh);
  wrapping.fineness = fineness;
  wrapping.volume = CGAL::to_double(PMP::volume(wrap));
  for (const auto f : wrap.faces()) {
    Vec3 centre = Vec3::Zero();
    for (const auto v : wrap.vertices_around_face(wrap.halfedge(f))) centre += vec(wrap.point(v)) / 3.0;
    wrapping.farthest_point = std::max(
        wrapping.farthest_point,
        std::sqrt(CGAL::to_double(tree.squared_distance(Point(centre.x(), centre.y(), centre.z())))));
  }
  QuadMesh result;
  append(result, wrap);
  return result;
}

}  // namespace icebow
