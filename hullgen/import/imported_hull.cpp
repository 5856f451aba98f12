#include "hullgen/import/imported_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/errors.h"
#include "base/text.h"
#include "base/units.h"
#include "geometry/mesh_slice.h"
#include "hullgen/cad/cad_import.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/import/chord_points.h"
#include "hullgen/import/offsets.h"
#include "hullgen/import/waterline.h"
#include "hullgen/mesh/mesh_check.h"
#include "hullgen/mesh/mesh_edges.h"
#include "hullgen/mesh/mesh_holes.h"
#include "hullgen/mesh/mesh_io.h"
#include "hullgen/mesh/mesh_repair.h"
#include "hullgen/mesh/mesh_solids.h"
#include "hullgen/mesh/mesh_visibility.h"
#include "hullgen/mesh/mesh_wrap.h"
#include "hullgen/mesh/panel_orientation.h"

namespace icebow {
namespace {

constexpr double full_beam = 0.995;  // of the beam: a faired shoulder has no corner to find
constexpr double level = 0.9;        // of a unit normal: the panel lies flat

constexpr double well = 0.2;     // of the waterline's area: a larger hole in it is no well
constexpr double unlike = 2e-3;  // of the beam: half-breadths that differ by more are told
constexpr double wrap_fineness = 1.0 / 200.0, wrap_distance = 1.0 / 1000.0;  // of the mesh's length

std::string place(const Vec3& p) {
  return text("(%.4g, %.4g, %.4g) m", p.x(), p.y(), p.z());
}

// Beyond the mending of single flaws: CGAL's wrap stands for the mesh, where it stays close to it.
QuadMesh wrap_of(const QuadMesh& mesh, const std::string& why, const std::string& file,
                 MeshRepairs& repairs) {
  const Box box = bounding_box(mesh);
  const double length = (box.upper - box.lower).maxCoeff();
  Wrapping wrapping;
  QuadMesh wrap = wrapped(mesh, wrap_fineness * length, wrapping);
  if (!check_mesh(wrap).ok() || wrapping.farthest_point > wrap_distance * length)
    throw InputError(file + ": " + why +
                     ": mend it where the mesh was made; surfaces that overlap must be united into one");
  repairs.warnings.push_back(why + text(": it could not be mended, so a wrap stands for it, with features "
                                        "down to %.2g m, a volume of %.6g m3 "
                                        "(the mesh as it stands: %.6g m3) and a distance of at most %.2g m "
                                        "from it; edges are rounded by it, angles "
                                        "less certain",
                                        wrapping.fineness, wrapping.volume, enclosed_volume(mesh),
                                        wrapping.farthest_point));
  repairs.components = 1;
  return wrap;
}

// Closed, outward, without crossings.
QuadMesh sound(QuadMesh mesh, const std::string& file, MeshRepairs& repairs) {
  MeshCheck check = check_mesh(mesh);
  if (check.ok()) return mesh;
  const QuadMesh before = mesh;
  make_solid(mesh, repairs);
  const std::string first = check.reason();
  check = check_mesh(mesh);
  if (check.ok()) return mesh;
  return wrap_of(before, check.self_intersecting ? check.reason() : first, file, repairs);
}

// The outer skin of an open boat that was drawn with its plating, closed by a deck.
QuadMesh outer_skin(const QuadMesh& mesh, const std::string& file, MeshRepairs& repairs) {
  QuadMesh skin = outer_surface(mesh);
  const auto left_out = mesh.quads.size() - skin.quads.size();
  const HoleRepairs holes = fill_holes(skin);
  repairs.notes.push_back(text("%zu panels of the inside were left out", left_out));
  repairs.notes.insert(repairs.notes.end(), holes.words.begin(), holes.words.end());
  skin = without_unused_points(skin);
  repairs.components = turn_outward(skin, file, repairs.turned);
  return skin;
}

QuadMesh solid(QuadMesh mesh, const std::string& file, const ImportChoice& choice, MeshRepairs& repairs) {
  if (choice.progress) choice.progress("mending", 0.0);
  if (choice.mirror) mesh = with_mirror_image(mesh, file, repairs);
  mesh = repaired(mesh, file, repairs);
  if (choice.outer_surface) mesh = outer_skin(mesh, file, repairs);
  if (choice.progress) choice.progress("looking for crossings", 0.0);
  return sound(std::move(mesh), file, repairs);
}

void refuse_inside_of_boat(const Waterline& w, const std::string& file, MeshRepairs& repairs) {
  if (w.hole_area <= 0.0) return;
  const std::string what =
      text("the waterline has a loop inside a loop, at %s: %.4g of %.4g m2 within it are not hull",
           place(w.hole).c_str(), w.hole_area, w.area);
  if (w.hole_area < well * w.area) return repairs.warnings.push_back(what + " (a well?)");
  throw InputError(
      file + ": " + what +
      ", as of an open boat drawn with its plating, which would fill with water: ask for the outer surface "
      "(\"outer_surface\": true in a study, --outer of icebow measure), or close the deck");
}

// The waterplane's centroid [y, m].
double centroid(const QuadMesh& mesh) {
  double twice_area = 0.0, six_moments = 0.0;  // by the shoelace formula
  for (const Polyline& loop : slice(mesh, 2, 0.0))
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      const double cross = p.x() * q.y() - q.x() * p.y();
      twice_area += cross;
      six_moments += (p.y() + q.y()) * cross;
    }
  return twice_area != 0.0 ? six_moments / (3.0 * twice_area) : 0.0;
}

// The hull's centre plane is the middle of its waterline, unless the file's own y = 0 halves the waterplane:
// cranes and rudders to one side do not count.
void centre(QuadMesh& mesh, const Waterline& w, MeshRepairs& repairs) {
  const double middle = 0.5 * (w.port + w.starboard), beam = w.port - w.starboard;
  if (std::abs(middle) <= 1e-6 * beam || std::abs(centroid(mesh)) <= 1e-6 * beam) return;
  for (Vec3& p : mesh.points) p.y() -= middle;
  repairs.notes.push_back(
      text("the centre plane is at y = %.6g m of the file, the middle of the waterline", middle));
}

// Angles are read on port, and B/4 is counted from y = 0.
void require_symmetry(const QuadMesh& mesh, double beam, const std::string& file) {
  const double off = centroid(mesh);
  if (std::abs(off) <= 1e-3 * beam) return;
  throw InputError(
      text("%s: the waterplane's centroid is %g m to %s of the centre plane: the two sides of a hull must be "
           "alike; mend the file, or import one side of it, mirrored",
           file.c_str(), std::abs(off), off > 0.0 ? "port" : "starboard"));
}

// Half-breadths of a loop at x: to port and to starboard.
std::pair<double, double> half_breadths(const Polyline& loop, double x) {
  double port = 0.0, starboard = 0.0;
  for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
    const Vec3 &p = loop[k], &q = loop[k + 1];
    if ((p.x() >= x) == (q.x() >= x)) continue;
    const double y = p.y() + (x - p.x()) / (q.x() - p.x()) * (q.y() - p.y());
    port = std::max(port, y), starboard = std::max(starboard, -y);
  }
  return {port, starboard};
}

// The two sides beside each other at the waterline and at half the draught.
void compare_sides(const ImportedHull& hull, MeshRepairs& repairs) {
  double worst = 0.0;
  std::string words;
  for (const double z : {0.0, -0.5 * hull.T}) {
    const Polyline loop = waterline_at(hull.mesh, z).loop;
    if (loop.empty()) continue;
    double aft = loop[0].x(), fore = aft;
    for (const Vec3& p : loop) aft = std::min(aft, p.x()), fore = std::max(fore, p.x());
    for (int k = 1; k < 40; ++k) {
      const double x = aft + k / 40.0 * (fore - aft);
      const auto [port, starboard] = half_breadths(loop, x);
      if (std::abs(port - starboard) <= worst) continue;
      worst = std::abs(port - starboard);
      words = text("at x = %.4g, z = %.3g m the half-breadth is %.4g m to port and %.4g m to starboard", x, z,
                   port, starboard);
    }
  }
  if (worst <= unlike * hull.B) return;
  const BowAngles &p = hull.measured.angles, &s = hull.measured.starboard;
  repairs.warnings.push_back("the two sides differ: " + words +
                             text("; the angles are port's, starboard has stem %.2f, waterline %.2f, buttock "
                                  "%.2f, flare %.2f deg (port: "
                                  "%.2f, %.2f, %.2f, %.2f)",
                                  degrees(s.stem), degrees(s.waterline), degrees(s.buttock), degrees(s.flare),
                                  degrees(p.stem), degrees(p.waterline), degrees(p.buttock),
                                  degrees(p.flare)));
}

void mark_angles(const BowAngles& a, MeshRepairs& repairs) {
  const auto mark = [&](const char* name, double angle, double least) {
    if (!std::isfinite(angle))
      return repairs.warnings.push_back(
          text("the %s angle cannot be read at the waterline: no panel reaches away from the "
               "place",
               name));
    if (angle < least || angle > radians(90.0 + 1e-6))
      repairs.warnings.push_back(text("the %s angle of %.2f deg is none of an icebreaking bow (%s90 deg)",
                                      name, degrees(angle), least > 0.0 ? "above 0 up to " : "0 to "));
  };
  mark("stem", a.stem, radians(1e-6));
  mark("waterline", a.waterline, radians(1e-6));
  mark("buttock", a.buttock, radians(1e-6));
  mark("flare", a.flare, radians(-1e-6));
}

HullMeasurement measured(const QuadMesh& mesh, const std::vector<int>& on_chords, const std::string& file,
                         const Waterline& w, MeshRepairs& repairs) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  try {
    HullMeasurement m = measure_both_sides(mesh, on_chords);
    mark_angles(m.angles, repairs);
    return m;
  } catch (const InputError& error) {
    if (w.loop.empty()) throw InputError(file + ": " + error.what());
    // Two hulls side by side, or a waterline that misses the centre plane: everything but the angles is
    // known.
    repairs.warnings.push_back(std::string("the angles cannot be read: ") + error.what());
    HullMeasurement m;
    m.angles = m.starboard = {none, none, none, none};
    m.waterline_at_quarter_beam = m.flare_at_stem = none;
    m.beam = w.port - w.starboard;
    m.P0 = m.P1 = *std::max_element(w.loop.begin(), w.loop.end(),
                                    [](const Vec3& p, const Vec3& q) { return p.x() < q.x(); });
    return m;
  }
}

// A hull that displaces more than the box around its waterline is not afloat there.
void require_block_coefficient(const ImportedHull& hull) {
  const Hydrostatics h = hydrostatics(hull.mesh, {}, 1000.0);
  if (h.block_coefficient <= 1.0 + 1e-6) return;
  throw InputError(
      text("%s: under the waterline it has %.6g m3, more than the box of %.4g x %.4g x %.4g m around it (C_B "
           "= %.3f): the "
           "hull is wider or longer below than at the waterline; is the height of the waterline right, the "
           "unit, the axes?",
           hull.file.c_str(), h.volume, h.length, h.beam, h.draft, h.block_coefficient));
}

// Where the waterline first has its full breadth, and where it ends [x, m].
struct WaterlineEnds {
  double shoulder, aft;
};
WaterlineEnds waterline_ends(const QuadMesh& mesh, double beam) {
  const double y = 0.5 * full_beam * beam;
  WaterlineEnds ends{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const Polyline loop = waterline_at(mesh, 0.0).loop;
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

}  // namespace

ImportedHull import_hull(const std::string& file, const MeshFrame& frame, const ImportChoice& choice) {
  MeshRepairs repairs;
  ImportChoice own = choice;
  QuadMesh mesh;
  if (is_cad_file(file)) {
    mesh = read_cad(file, repairs.notes);
  } else if (ending_of(file) == ".csv") {
    mesh = lofted_half(read_offsets(file));
    own.mirror = true;  // a table of offsets is one side
  } else if (is_mesh_file(file)) {
    mesh = read_mesh(file, repairs, choice.progress);
  } else {
    throw InputError(
        file +
        ": no hull file that can be read; the name must end in .obj, .stl, .ply (meshes), .step, .stp, .igs, "
        ".iges (surfaces) or .csv (offsets)");
  }
  mesh = in_hull_frame(without_unused_points(mesh), frame);
  return hull_of_mesh(std::move(mesh), file, own, repairs);
}

ImportedHull hull_of_mesh(QuadMesh mesh, const std::string& file, const ImportChoice& choice,
                          const MeshRepairs& repairs) {
  ImportedHull hull;
  hull.file = file;
  hull.repairs = repairs;
  hull.mesh = solid(std::move(mesh), file, choice, hull.repairs);
  hull.on_chords = points_at(hull.mesh, hull.repairs.on_edges);
  const Waterline waterline = waterline_at(hull.mesh, 0.0);
  refuse_inside_of_boat(waterline, file, hull.repairs);
  if (waterline.islands > 0 && waterline.area > 0.0)
    hull.repairs.notes.push_back(
        text("the waterline has %d more %s beside the largest, which is taken for the ship's",
             waterline.islands, waterline.islands == 1 ? "loop" : "loops"));
  if (!choice.mirror) centre(hull.mesh, waterline, hull.repairs);
  if (choice.progress) choice.progress("measuring", 0.0);
  hull.measured = measured(hull.mesh, hull.on_chords, file, waterline, hull.repairs);
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
  require_block_coefficient(hull);
  compare_sides(hull, hull.repairs);
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
