#include "hullgen/mesh/mesh_import.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "base/file_kind.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_io.h"
#include "hullgen/mesh/ply_file.h"
#include "hullgen/mesh/read_obj.h"
#include "hullgen/mesh/read_stl.h"
#include "hullgen/mesh/ring_triangles.h"

namespace icebow {
namespace {

using Corners = std::vector<int>;

void add_panel(QuadMesh& mesh, const Corners& c, Patch patch) {
  mesh.quads.push_back({c[0], c[1], c[2], c.back()});
  mesh.patch.push_back(patch);
}

// A corner given twice in a row is one.
Corners without_repeats(Corners c) {
  c.erase(std::unique(c.begin(), c.end()), c.end());
  while (c.size() > 1 && c.front() == c.back()) c.pop_back();
  return c;
}

void add_polygon(QuadMesh& mesh, const Corners& polygon, Patch patch, const std::string& path, int& split) {
  if (polygon.size() < 3) return;
  if (polygon.size() <= 4) return add_panel(mesh, polygon, patch);
  const std::vector<std::array<int, 3>> parts = ring_triangles(mesh.points, polygon);
  const Vec3& p = mesh.points[static_cast<std::size_t>(polygon[0])];
  if (parts.empty())
    throw InputError(
        text("%s: a panel of %zu corners, one of them at (%g, %g, %g) in the file's coordinates, crosses "
             "itself or has "
             "no area: export the mesh as triangles",
             path.c_str(), polygon.size(), p.x(), p.y(), p.z()));
  for (const auto& t : parts) add_panel(mesh, {t[0], t[1], t[2]}, patch);
  ++split;
}

QuadMesh of_quads(PolygonMesh polygons, const std::string& path, MeshRepairs& repairs) {
  QuadMesh mesh;
  mesh.points = std::move(polygons.points);
  mesh.quads.reserve(polygons.size());
  mesh.patch.reserve(polygons.size());
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    if (!mesh.points[k].allFinite())
      throw InputError(text("%s: point %zu has a coordinate that is not a finite number: export it again",
                            path.c_str(), k + 1));
  for (std::size_t k = 0; k < polygons.size(); ++k)
    add_polygon(mesh, without_repeats(polygons.polygon(k)), polygons.patch[k], path, repairs.split);
  repairs.notes.insert(repairs.notes.end(), polygons.notes.begin(), polygons.notes.end());
  return mesh;
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".obj" || ending == ".stl" || ending == ".ply";
}

QuadMesh read_mesh(const std::string& path, MeshRepairs& repairs, const ImportProgress& progress) {
  const std::string ending = ending_of(path);
  if (!is_mesh_file(path))
    throw InputError(path + ": no mesh format that can be read; the name must end in .obj, .stl or .ply");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": " + why_no_file(path));
  return of_quads(ending == ".obj"   ? read_obj(path, progress)
                  : ending == ".stl" ? read_stl(path, progress)
                                     : read_ply(path),
                  path, repairs);
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

}  // namespace icebow
