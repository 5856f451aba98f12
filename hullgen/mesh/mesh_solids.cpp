#include "hullgen/mesh/mesh_solids.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "base/text.h"
#include "geometry/triangles.h"
#include "hullgen/mesh/mesh_edges.h"

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

Point point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}
Vec3 vec(const Point& p) {
  return {p.x(), p.y(), p.z()};
}
std::string place(const Vec3& p) {
  return text("(%.3g, %.3g, %.3g) m", p.x(), p.y(), p.z());
}

// The triangles of some panels as a surface of their own.
Surface surface_of(const QuadMesh& mesh) {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> facets = triangles(mesh);
  std::vector<int> number(mesh.points.size(), -1);
  for (auto& t : facets)
    for (int& k : t) {
      if (number[k] < 0) {
        number[k] = static_cast<int>(points.size());
        points.push_back(point(mesh.points[k]));
      }
      k = number[k];
    }
  Surface surface;
  if (PMP::is_polygon_soup_a_polygon_mesh(facets)) PMP::polygon_soup_to_polygon_mesh(points, facets, surface);
  return surface;
}

void append(QuadMesh& mesh, const Surface& surface, Patch patch = Patch::other) {
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
    mesh.patch.push_back(patch);
  }
}

void append(QuadMesh& mesh, const QuadMesh& part) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (auto q : part.quads) {
    for (int& k : q) k += first;
    mesh.quads.push_back(q);
  }
  mesh.patch.insert(mesh.patch.end(), part.patch.begin(), part.patch.end());
}

bool contains(const Box& outer, const Box& inner) {
  return (inner.lower.array() >= outer.lower.array()).all() &&
         (inner.upper.array() <= outer.upper.array()).all();
}
bool overlap(const Box& a, const Box& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

// One closed surface; `surface` is made where it is needed.
struct Body {
  QuadMesh mesh;
  Box box;
  double volume = 0.0;
  bool changed = false;  // `surface` holds it, `mesh` no longer does
  Surface surface;

  const Surface& as_surface() {
    if (surface.number_of_faces() == 0) surface = surface_of(mesh);
    return surface;
  }
};

std::vector<Body> bodies_of(const QuadMesh& mesh) {
  int n = 0;
  const std::vector<int> number = surface_of_panel(mesh, n);
  std::vector<Body> bodies(n);
  for (int b = 0; b < n; ++b) {
    bodies[b].mesh = without_unused_points(with_panels(mesh, [&](std::size_t k) { return number[k] == b; }));
    bodies[b].box = bounding_box(bodies[b].mesh);
    bodies[b].volume = enclosed_volume(bodies[b].mesh);
  }
  std::sort(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) { return a.volume > b.volume; });
  return bodies;
}

bool touch(Body& a, Body& b) {
  return overlap(a.box, b.box) && PMP::do_intersect(a.as_surface(), b.as_surface());
}

void leave_out_inner(std::vector<Body>& bodies, MeshRepairs& repairs) {
  for (std::size_t outer = 0; outer < bodies.size(); ++outer)
    for (std::size_t k = bodies.size(); k-- > outer + 1;) {
      Body &a = bodies[outer], &b = bodies[k];
      if (!contains(a.box, b.box) || touch(a, b)) continue;
      const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(a.as_surface());
      if (side(point(b.mesh.points[0])) != CGAL::ON_BOUNDED_SIDE) continue;
      repairs.notes.push_back("one closed surface lies inside another, at " + place(b.mesh.points[0]) +
                              text(", %.4g m3: it was left out", b.volume));
      bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

bool unite(Body& a, Body& b) {
  Surface one = a.as_surface(), two = b.as_surface(), both;
  if (!PMP::does_bound_a_volume(one) || !PMP::does_bound_a_volume(two)) return false;
  try {
    if (!PMP::corefine_and_compute_union(one, two, both)) return false;
  } catch (const std::exception&) {
    return false;
  }
  both.collect_garbage();
  if (!CGAL::is_closed(both) || PMP::does_self_intersect(both)) return false;
  a.surface = std::move(both);
  a.changed = true;
  a.box = {a.box.lower.cwiseMin(b.box.lower), a.box.upper.cwiseMax(b.box.upper)};
  return true;
}

// Bodies that touch without overlapping (an edge on a deck): the smaller one draws back by a hair.
void draw_back(Body& b, double by) {
  const Vec3 centre = 0.5 * (b.box.lower + b.box.upper);
  const double size = (b.box.upper - b.box.lower).maxCoeff();
  for (Vec3& p : b.mesh.points) p = (centre + (1.0 - 2.0 * by / size) * (p - centre)).eval();
  b.surface.clear();
}

void unite_overlapping(std::vector<Body>& bodies, double hair, MeshRepairs& repairs) {
  int united = 0, parted = 0;
  Vec3 at = Vec3::Zero();
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size();) {
      if (!touch(bodies[a], bodies[b])) {
        ++b;
        continue;
      }
      const Vec3 middle = 0.5 * (bodies[b].box.lower + bodies[b].box.upper);
      if (unite(bodies[a], bodies[b])) {
        if (united++ == 0) at = middle;
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(b));
        b = a + 1;  // what touched nothing may touch the two together
        continue;
      }
      if (!bodies[b].changed) {
        draw_back(bodies[b], hair);
        if (!touch(bodies[a], bodies[b])) ++parted;
      }
      ++b;
    }
  if (united > 0)
    repairs.notes.push_back(text("%d closed %s overlapped or touched another and %s united with it, at ",
                                 united, united == 1 ? "surface" : "surfaces", united == 1 ? "was" : "were") +
                            place(at));
  if (parted > 0)
    repairs.notes.push_back(
        text("%d closed %s touched another in an edge or a corner and %s drawn back by %.2g mm", parted,
             parted == 1 ? "surface" : "surfaces", parted == 1 ? "was" : "were", 1e3 * hair));
}

}  // namespace

bool make_solid(QuadMesh& mesh, MeshRepairs& repairs) {
  const Box box = bounding_box(mesh);
  const double hair = 1e-6 * (box.upper - box.lower).maxCoeff();
  std::vector<Body> bodies = bodies_of(mesh);
  leave_out_inner(bodies, repairs);
  const bool sound = std::none_of(bodies.begin(), bodies.end(),
                                  [](Body& b) { return PMP::does_self_intersect(b.as_surface()); });
  if (sound) unite_overlapping(bodies, hair, repairs);
  QuadMesh result;
  for (const Body& body : bodies) {
    if (body.changed)
      append(result, body.surface);
    else
      append(result, body.mesh);
  }
  mesh = std::move(result);
  repairs.components = static_cast<int>(bodies.size());
  return sound;
}

}  // namespace icebow
