#include <cmath>
#include <iostream>
#include <map>

#include "base/errors.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/hydrostatics_text.h"
#include "cli/number_option.h"
#include "cli/text_table.h"
#include "hullgen/import/imported_hull.h"
#include "hullgen/mesh/mesh_check.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr double sea_water = 1025.0;  //!< [kg/m^3]

double unit_option(const Arguments& arguments) {
  static const std::map<std::string, double> units = {
      {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};
  if (!arguments.has("--unit")) return 1.0;
  const auto unit = units.find(arguments.value("--unit"));
  if (unit != units.end()) return unit->second;
  std::vector<std::string> known;
  for (const auto& [name, metres] : units) known.push_back(name);
  throw InputError("--unit " + arguments.value("--unit") + ": give one of " + listed(known));
}

// "x", "-z": an axis of the file; zero where it is neither.
Vec3 axis(const std::string& name) {
  const bool minus = !name.empty() && name[0] == '-';
  const std::size_t k = name.size() == (minus ? 2U : 1U) ? std::string("xyz").find(name.back()) : 3;
  return k < 3 ? Vec3((minus ? -1.0 : 1.0) * Vec3::Unit(static_cast<int>(k))) : Vec3(Vec3::Zero());
}

MeshFrame frame_options(const Arguments& arguments) {
  MeshFrame frame;
  frame.unit = unit_option(arguments);
  frame.waterline = number_option(arguments, "--waterline", 0.0, -1e3, 1e3, "m");
  if (!arguments.has("--axes")) return frame;
  const std::string axes = arguments.value("--axes");
  const std::size_t comma = axes.find(',');
  frame.forward = axis(axes.substr(0, comma));
  frame.up = comma == std::string::npos ? Vec3(Vec3::Zero()) : axis(axes.substr(comma + 1));
  if (frame.forward.norm() * frame.up.norm() == 0.0 || frame.forward.dot(frame.up) != 0.0)
    throw InputError("--axes " + axes +
                     ": give the file's axis that points forward and the one that points up, two different "
                     "ones of x, y, z, -x, -y, -z, like x,z or -z,y");
  return frame;
}

struct Size {
  const char* name;
  const char* key;
  double metres;
};
std::vector<Size> sizes(const QuadMesh& mesh, const HullMeasurement& hull, const Hydrostatics& h) {
  const Box box = bounding_box(mesh);
  const Vec3 all = box.upper - box.lower;
  return {{"length over all", "length_over_all_m", all.x()},
          {"beam over all", "beam_over_all_m", all.y()},
          {"depth", "depth_m", all.z()},
          {"length on the waterline", "waterline_length_m", h.length},
          {"beam on the waterline", "waterline_beam_m", hull.beam},
          {"draft", "draft_m", h.draft}};
}

struct NamedAngle {
  const char* name;
  const char* key;
  double radians;
};
std::vector<NamedAngle> angles(const HullMeasurement& hull) {
  return {{"stem, at P0", "stem", hull.angles.stem},
          {"waterline, at P0", "waterline", hull.angles.waterline},
          {"buttock, at P1", "buttock", hull.angles.buttock},
          {"flare, at P1", "flare", hull.angles.flare},
          {"waterline at B/4", "waterline_at_quarter_beam", hull.waterline_at_quarter_beam},
          {"flare at the stem", "flare_at_stem", hull.flare_at_stem}};
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json point_json(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Json measurement_json(const QuadMesh& mesh, const HullMeasurement& hull, const HydrostaticsReport& report) {
  const MeshCheck check = check_mesh(mesh);
  Json json = {{"mesh", {{"points", check.points}, {"quads", check.quads}, {"triangles", check.triangles}}},
               {"P0_m", point_json(hull.P0)},
               {"P1_m", point_json(hull.P1)},
               {"hydrostatics", hydrostatics_json(report)}};
  for (const Size& s : sizes(mesh, hull, report.values)) json["dimensions"][s.key] = s.metres;
  for (const NamedAngle& a : angles(hull)) json["angles_deg"][a.key] = number(degrees(a.radians));
  return json;
}

std::string measurement_text(const QuadMesh& mesh, const HullMeasurement& hull,
                             const HydrostaticsReport& report) {
  std::vector<std::vector<std::string>> rows = {{"dimensions", "m"}};
  for (const Size& s : sizes(mesh, hull, report.values)) rows.push_back({s.name, decimals(s.metres, 3)});
  std::string text = text_table(rows);
  rows = {{"angle", "deg"}};
  for (const NamedAngle& a : angles(hull)) rows.push_back({a.name, decimals(degrees(a.radians), 3)});
  const auto place = [](const Vec3& p) { return "(" + decimals(p.x(), 3) + ", " + decimals(p.y(), 3) + ")"; };
  return text + "\n" + text_table(rows) + "P0 at (x, y) = " + place(hull.P0) + " m, P1 at " + place(hull.P1) +
         " m on the waterline\n\n" + hydrostatics_text(report);
}

}  // namespace

int run_measure(const Communicator&, const Arguments& arguments) {
  const std::string path = arguments.positional;
  const MeshFrame frame = frame_options(arguments);
  const double density = number_option(arguments, "--density", sea_water, 500.0, 1500.0, "kg/m3");
  const ImportedHull imported = import_hull(path, frame, arguments.has("--mirror"));
  const QuadMesh& mesh = imported.mesh;
  const HullMeasurement& hull = imported.measured;
  // The draft of an even keel is the same everywhere: x only says where trim would turn.
  const HydrostaticsReport report = hydrostatics_report(mesh, {}, density);
  if (arguments.has("--json")) {
    Json json = measurement_json(mesh, hull, report);
    json["stem_m"] = imported.stem;
    json["repairs"] = in_words(imported.repairs);
    std::cout << json.dump(2) << "\n";
  } else {
    std::cout << path << ": " << mesh.quads.size() << " panels, closed, free of self-intersections\n";
    for (const std::string& words : in_words(imported.repairs)) std::cout << "repaired: " << words << "\n";
    std::cout << "the stem is at " << decimals(imported.stem, 3) << " m along the file's forward axis\n\n"
              << measurement_text(mesh, hull, report);
  }
  return exit_code::ok;
}

}  // namespace icebow
