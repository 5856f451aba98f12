#include "hullgen/import/imported_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/mesh_slice.h"
#include "hullgen/mesh/mesh_check.h"

namespace icebow {
namespace {

constexpr double full_beam = 0.995;  // of the beam: a faired shoulder has no corner to find
constexpr double level = 0.9;        // of a unit normal: the panel lies flat

void check(const QuadMesh& mesh, const std::string& file) {
  const MeshCheck check = check_mesh(mesh);
  if (check.ok()) return;
  throw InputError(file + ": " + check.reason() +
                   ": mend it where the mesh was made; surfaces that overlap must be united into one");
}

void require_angle(double angle, const char* name, const std::string& file) {
  if (std::isfinite(angle)) return;
  throw InputError(
      text("%s: the %s angle cannot be read at the waterline: no panel reaches away from the "
           "place; use smaller panels there",
           file.c_str(), name));
}

HullMeasurement measured(const QuadMesh& mesh, const std::string& file) {
  HullMeasurement m;
  try {
    m = measure_hull(mesh);
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
  require_angle(m.angles.stem, "stem", file);
  require_angle(m.angles.waterline, "waterline", file);
  require_angle(m.angles.buttock, "buttock", file);
  require_angle(m.angles.flare, "flare", file);
  return m;
}

// The angles are read on port, and B/4 is counted from y = 0.
void require_symmetry(const QuadMesh& mesh, double beam, const std::string& file) {
  double twice_area = 0.0, six_moments = 0.0;  // of the waterplane, by the shoelace formula
  for (const Polyline& loop : slice(mesh, 2, 0.0))
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      const double cross = p.x() * q.y() - q.x() * p.y();
      twice_area += cross;
      six_moments += (p.y() + q.y()) * cross;
    }
  const double off = six_moments / (3.0 * twice_area);
  if (std::abs(off) <= 1e-3 * beam) return;
  throw InputError(
      text("%s: the waterplane's centroid is %g m to %s of the centre plane: the two sides of a hull must be "
           "alike; "
           "mend the file, or import one side of it, mirrored",
           file.c_str(), std::abs(off), off > 0.0 ? "port" : "starboard"));
}

// Where the waterline first has its full breadth, and where it ends [x, m].
struct WaterlineEnds {
  double shoulder, aft;
};
WaterlineEnds waterline_ends(const QuadMesh& mesh, double beam) {
  const double y = 0.5 * full_beam * beam;
  WaterlineEnds ends{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Polyline& loop : slice(mesh, 2, 0.0))
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      ends.aft = std::min(ends.aft, p.x());
      const double from = std::abs(p.y()), to = std::abs(q.y());
      if ((from >= y) == (to >= y)) continue;
      ends.shoulder = std::max(ends.shoulder, p.x() + (y - from) / (to - from) * (q.x() - p.x()));
    }
  return ends;
}

Patch patch_at(const QuadMesh& mesh, const std::array<int, 4>& q, double shoulder) {
  const Vec3 &a = mesh.points[q[0]], &b = mesh.points[q[1]], &c = mesh.points[q[2]], &d = mesh.points[q[3]];
  const Vec3 normal = (c - a).cross(d - b).normalized();
  const Vec3 centre = 0.25 * (a + b + c + d);
  if (normal.z() > level && centre.z() > 0.0) return Patch::deck;
  if (normal.x() < -level) return Patch::transom;
  if (normal.z() < -level) return Patch::bottom;
  return centre.x() > shoulder ? Patch::bow : Patch::side;
}

void add_patches(QuadMesh& mesh, double shoulder) {
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    if (mesh.patch[k] == Patch::other) mesh.patch[k] = patch_at(mesh, mesh.quads[k], shoulder);
}

QuadMesh solid(const std::string& file, const MeshFrame& frame, bool mirror, MeshRepairs& repairs) {
  QuadMesh mesh = in_hull_frame(without_unused_points(read_mesh(file, repairs.split)), frame);
  mesh = mirror ? with_mirror_image(mesh, file, repairs) : centred(mesh);
  mesh = repaired(mesh, file, repairs);
  check(mesh, file);
  return mesh;
}

}  // namespace

ImportedHull import_hull(const std::string& file, const MeshFrame& frame, bool mirror) {
  ImportedHull hull;
  hull.file = file;
  hull.mesh = solid(file, frame, mirror, hull.repairs);
  hull.measured = measured(hull.mesh, file);
  hull.stem = hull.measured.P0.x();
  for (Vec3& p : hull.mesh.points) p.x() -= hull.stem;
  hull.measured.P0.x() -= hull.stem;
  hull.measured.P1.x() -= hull.stem;
  require_symmetry(hull.mesh, hull.measured.beam, file);
  const WaterlineEnds ends = waterline_ends(hull.mesh, hull.measured.beam);
  const Box box = bounding_box(hull.mesh);
  hull.L = -ends.aft;
  hull.B = hull.measured.beam;
  hull.T = -box.lower.z();
  hull.D = box.upper.z() - box.lower.z();
  hull.Lf = -ends.shoulder;
  add_patches(hull.mesh, ends.shoulder);
  return hull;
}

Hull as_hull(const ImportedHull& imported) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Hull hull;
  hull.status = HullStatus::ok;
  hull.form = "imported from " + std::filesystem::path(imported.file).filename().string();
  hull.feasibility.feasible = true;
  hull.requested = {none, none, none, none};
  hull.mesh = imported.mesh;
  hull.measured = imported.measured.angles;
  hull.waterline_at_quarter_beam = imported.measured.waterline_at_quarter_beam;
  hull.flare_at_stem = imported.measured.flare_at_stem;
  return hull;
}

}  // namespace icebow
