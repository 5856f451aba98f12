#include "hullgen/mesh_import.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/errors.h"
#include "hullgen/mesh_check.h"
#include "hullgen/mesh_io.h"
#include "hullgen/text.h"

namespace icebow {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;

// By CGAL; it says of a file it cannot read only that it could not.
QuadMesh read_soup(const std::string& path) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons) || polygons.empty())
    throw InputError(path + ": is not a mesh that can be read: export it again as STL, PLY or OBJ");
  PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  QuadMesh mesh;
  for (const Point& p : points) mesh.points.push_back(Vec3(p.x(), p.y(), p.z()));
  for (const auto& p : polygons) {
    if (p.size() != 3 && p.size() != 4)
      throw InputError(
          text("%s: a panel has %zu corners: split it into triangles or quads", path.c_str(), p.size()));
    const auto corner = [&p](std::size_t k) { return static_cast<int>(p[std::min(k, p.size() - 1)]); };
    mesh.quads.push_back({corner(0), corner(1), corner(2), corner(3)});
  }
  mesh.patch.assign(mesh.quads.size(), Patch::other);
  return mesh;
}

void turn_over(QuadMesh& mesh) {
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    auto& q = mesh.quads[k];
    q = mesh.is_triangle(k) ? std::array<int, 4>{q[0], q[2], q[1], q[1]}
                            : std::array<int, 4>{q[0], q[3], q[2], q[1]};
  }
}

// Directed edges that no neighbour runs the other way.
std::string open_edges(const QuadMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& q : mesh.quads)
    for (int k = 0; k < 4; ++k)
      if (q[k] != q[(k + 1) % 4]) ++edges[{q[k], q[(k + 1) % 4]}];
  int open = 0;
  Vec3 where = Vec3::Zero();
  for (const auto& [edge, count] : edges) {
    if (edges.count({edge.second, edge.first}) > 0) continue;
    if (open++ == 0) where = 0.5 * (mesh.points[edge.first] + mesh.points[edge.second]);
  }
  return text(
      "%d open edges, one at (%g, %g, %g) m in the frame of the hull: close deck and transom, and weld "
      "points that should be one",
      open, where.x(), where.y(), where.z());
}

}  // namespace

QuadMesh read_mesh(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".obj" && ending != ".stl" && ending != ".ply")
    throw InputError(path + ": no mesh format that can be read; the name must end in .obj, .stl or .ply");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": no such file");
  return ending == ".obj" ? read_obj(path) : read_soup(path);
}

QuadMesh in_hull_frame(const QuadMesh& mesh, const MeshFrame& frame) {
  const Vec3 port = frame.up.cross(frame.forward);
  QuadMesh result = mesh;
  for (Vec3& p : result.points)
    p = frame.unit * Vec3(p.dot(frame.forward), p.dot(port), p.dot(frame.up)) - Vec3(0, 0, frame.waterline);
  const Box box = bounding_box(result);
  const double middle = 0.5 * (box.lower.y() + box.upper.y());
  if (std::abs(middle) > 1e-6 * (box.upper.y() - box.lower.y()))
    for (Vec3& p : result.points) p.y() -= middle;
  return result;
}

QuadMesh outward(const QuadMesh& mesh, const std::string& path) {
  QuadMesh result = mesh;
  if (enclosed_volume(mesh) < 0.0) turn_over(result);
  const MeshCheck check = check_mesh(result);
  if (check.ok()) return result;
  throw InputError(path + ": " + check.reason() +
                   (check.valid_polygon_mesh && !check.closed ? ": " + open_edges(result) : ""));
}

}  // namespace icebow
