#include "hullgen/mesh/mesh_import.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_io.h"
#include "hullgen/mesh/ply_file.h"

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Corners = std::vector<int>;

constexpr std::size_t stl_head = 84, stl_triangle = 50;  // bytes of a binary STL file

// A binary STL file that announces more triangles than it has bytes for. The other kind begins with "solid".
void check_stl_size(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  char head[stl_head] = {};
  in.read(head, stl_head);
  if (static_cast<std::size_t>(in.gcount()) < stl_head || std::string(head, 5) == "solid") return;
  std::uint32_t count = 0;
  std::memcpy(&count, head + 80, sizeof count);
  const std::uint64_t there = (std::filesystem::file_size(path) - stl_head) / stl_triangle;
  if (count > there)
    throw InputError(
        text("%s: its header announces %u triangles, but the file has bytes for %llu: it is cut "
             "off or damaged, export it again",
             path.c_str(), count, static_cast<unsigned long long>(there)));
}

// By CGAL; it says of a file it cannot read only that it could not.
PolygonMesh read_stl(const std::string& path) {
  check_stl_size(path);
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  if (!CGAL::IO::read_STL(path, points, triangles) || triangles.empty())
    throw InputError(path + ": is not a mesh that can be read: export it again as STL, PLY or OBJ");
  PolygonMesh mesh;
  for (const Point& p : points) mesh.points.push_back(Vec3(p.x(), p.y(), p.z()));
  for (const auto& t : triangles) mesh.polygons.emplace_back(t.begin(), t.end());
  mesh.patch.assign(mesh.polygons.size(), Patch::other);
  return mesh;
}

void check_points(const PolygonMesh& mesh, const std::string& path) {
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    if (!mesh.points[k].allFinite())
      throw InputError(text("%s: point %zu has a coordinate that is not a finite number: export it again",
                            path.c_str(), k + 1));
}

// Points that are the same to the last bit become one.
PolygonMesh merged(const PolygonMesh& mesh, const std::string& path) {
  check_points(mesh, path);  // such a point is equal to none, itself included
  std::vector<Point> points;
  for (const Vec3& p : mesh.points) points.emplace_back(p.x(), p.y(), p.z());
  PolygonMesh result;
  result.polygons = mesh.polygons;
  result.patch = mesh.patch;
  PMP::merge_duplicate_points_in_polygon_soup(points, result.polygons);
  for (const Point& p : points) result.points.push_back(Vec3(p.x(), p.y(), p.z()));
  return result;
}

// A polygon in triangles, by a Delaunay triangulation of its shadow on its mean plane; none where it has no
// shadow without crossings.
std::vector<Corners> triangles_of(const std::vector<Vec3>& points, const Corners& polygon) {
  CGAL::Surface_mesh<Point> surface;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> vertices;
  for (const int k : polygon)
    vertices.push_back(surface.add_vertex(Point(points[k].x(), points[k].y(), points[k].z())));
  const auto face = surface.add_face(vertices);
  std::vector<Corners> result;
  if (face == surface.null_face() || !PMP::triangulate_face(face, surface)) return result;
  for (const auto f : surface.faces()) {
    Corners corners;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      corners.push_back(polygon[static_cast<std::size_t>(v)]);
    result.push_back(corners);
  }
  const bool all = std::all_of(result.begin(), result.end(), [](const Corners& c) { return c.size() == 3; });
  return all ? result : std::vector<Corners>();
}

void add_panel(QuadMesh& mesh, const Corners& c, Patch patch) {
  mesh.quads.push_back({c[0], c[1], c[2], c.back()});
  mesh.patch.push_back(patch);
}

QuadMesh of_quads(const PolygonMesh& polygons, const std::string& path, int& split) {
  QuadMesh mesh;
  mesh.points = polygons.points;
  for (std::size_t k = 0; k < polygons.polygons.size(); ++k) {
    const Corners& polygon = polygons.polygons[k];
    if (polygon.size() <= 4) {
      if (polygon.size() > 2) add_panel(mesh, polygon, polygons.patch[k]);
      continue;
    }
    const std::vector<Corners> parts = triangles_of(mesh.points, polygon);
    const Vec3& p = mesh.points[polygon[0]];
    if (parts.empty())
      throw InputError(
          text("%s: a panel of %zu corners, one of them at (%g, %g, %g) in the file's coordinates, crosses "
               "itself or has no area: export the mesh as triangles",
               path.c_str(), polygon.size(), p.x(), p.y(), p.z()));
    for (const Corners& part : parts) add_panel(mesh, part, polygons.patch[k]);
    ++split;
  }
  return mesh;
}

}  // namespace

QuadMesh read_mesh(const std::string& path, int& split) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".obj" && ending != ".stl" && ending != ".ply")
    throw InputError(path + ": no mesh format that can be read; the name must end in .obj, .stl or .ply");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": no such file");
  if (ending == ".obj") {
    const PolygonMesh mesh = read_obj(path);
    check_points(mesh, path);
    return of_quads(mesh, path, split);
  }
  return of_quads(merged(ending == ".ply" ? read_ply(path) : read_stl(path), path), path, split);
}

QuadMesh in_hull_frame(const QuadMesh& mesh, const MeshFrame& frame) {
  const Vec3 port = (frame.left_handed ? -1.0 : 1.0) * frame.up.cross(frame.forward);
  QuadMesh result = mesh;
  for (Vec3& p : result.points) p = frame.unit * Vec3(p.dot(frame.forward), p.dot(port), p.dot(frame.up));
  const double lowest = bounding_box(result).lower.z();
  const double waterline = frame.draft > 0.0 ? lowest + frame.draft : frame.waterline;
  for (Vec3& p : result.points) p.z() -= waterline;
  return result;
}

QuadMesh centred(const QuadMesh& mesh) {
  QuadMesh result = mesh;
  const Box box = bounding_box(mesh);
  const double middle = 0.5 * (box.lower.y() + box.upper.y());
  if (std::abs(middle) > 1e-6 * (box.upper.y() - box.lower.y()))
    for (Vec3& p : result.points) p.y() -= middle;
  return result;
}

}  // namespace icebow
