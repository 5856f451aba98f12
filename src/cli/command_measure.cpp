#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/text.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/hydrostatics_text.h"
#include "cli/number_option.h"
#include "cli/text_table.h"
#include "hullgen/drawing/curves_page.h"
#include "hullgen/drawing/lines_dxf.h"
#include "hullgen/drawing/svg_pdf.h"
#include "hullgen/hydro/curves_of_form.h"
#include "hullgen/import/hull_stations.h"
#include "hullgen/import/imported_hull.h"
#include "hullgen/import/offsets.h"
#include "hullgen/mesh/mesh_check.h"
#include "hullgen/mesh/mesh_io.h"
#include "study/evaluate/evaluation.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

// What was found, as a program and as a person read it.
struct MeasureReport {
  ImportedHull hull;
  HydrostaticsReport hydrostatics;
  WaterlineAngles upper, lower;  // along the ice waterlines
  ShellShares shell;             // of the forebody
  FormAtDraft form;              // the coefficients of the hydrostatics' draft
  struct {
    double tonnes = 0.0, draft = 0.0;  //!< asked for [t], 0: not; found [m]
  } draft_for_displacement;
};

struct Size {
  const char* name;
  const char* key;
  double metres;
};
std::vector<Size> sizes(const MeasureReport& report) {
  const Box box = bounding_box(report.hull.mesh);
  const Vec3 all = box.upper - box.lower;
  const Hydrostatics& h = report.hydrostatics.values;
  return {{"length over all", "length_over_all_m", all.x()},
          {"beam over all", "beam_over_all_m", all.y()},
          {"depth", "depth_m", all.z()},
          {"length on the waterline", "waterline_length_m", h.length},
          {"beam on the waterline", "waterline_beam_m", report.hull.measured.beam},
          {"draft", "draft_m", h.draft}};
}

struct NamedAngle {
  const char* name;
  const char* key;
  double angle, spread;  //!< [rad]
};
std::vector<NamedAngle> angles(const HullMeasurement& hull) {
  return {{"stem, at P0", "stem", hull.angles.stem, hull.spread.stem},
          {"waterline, at P0", "waterline", hull.angles.waterline, hull.spread.waterline},
          {"buttock, at P1", "buttock", hull.angles.buttock, hull.spread.buttock},
          {"flare, at P1", "flare", hull.angles.flare, hull.spread.flare},
          {"waterline at B/4", "waterline_at_quarter_beam", hull.waterline_at_quarter_beam,
           hull.spread_at_quarter_beam},
          {"flare at the stem", "flare_at_stem", hull.flare_at_stem,
           std::max(hull.spread.stem, hull.spread.waterline)}};
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json point_json(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Json stations_json(const WaterlineAngles& line, const char* name) {
  Json rows = Json::array();
  for (const StationAngles& s : line.stations)
    rows.push_back({{"ice_waterline", name},
                    {"share_of_bow", s.share},
                    {"x_m", s.at.x()},
                    {"y_m", s.at.y()},
                    {"z_m", s.at.z()},
                    {"waterline_deg", number(degrees(s.waterline))},
                    {"buttock_deg", number(degrees(s.buttock))},
                    {"flare_deg", number(degrees(s.flare))},
                    {"normal_flare_deg", number(degrees(s.normal_flare))},
                    {"plate_slope_deg", number(degrees(s.plate_slope))},
                    {"spread_deg", number(degrees(s.spread))}});
  return rows;
}

bool is_middle_of_quarter(double share) {
  const double eighths = 8.0 * share;
  return eighths == std::floor(eighths) && static_cast<int>(eighths) % 2 == 1;
}

// What the rules read off the upper ice waterline; see docs/bows.md for where the definitions come from.
Json rules_json(const MeasureReport& report) {
  const HullMeasurement& m = report.hull.measured;
  const double psi = std::atan2(std::tan(m.angles.buttock), std::sin(m.waterline_at_quarter_beam));
  Json parts = Json::array();
  for (const StationAngles& s : report.upper.stations)
    if (is_middle_of_quarter(s.share))
      parts.push_back({{"share_of_bow", s.share},
                       {"alpha_deg", number(degrees(s.waterline))},
                       {"gamma_deg", number(degrees(s.buttock))},
                       {"beta_deg", number(degrees(s.flare))},
                       {"beta_normal_deg", number(degrees(s.normal_flare))}});
  return {{"FSICR",
           {{"alpha_deg", number(degrees(m.waterline_at_quarter_beam))},
            {"phi1_deg", number(degrees(m.angles.stem))},
            {"phi2_deg", number(degrees(m.angles.buttock))},
            {"psi_deg", number(degrees(psi))}}},
          {"UR_I2", {{"stem_gamma_deg", number(degrees(m.angles.stem))}, {"sub_regions", parts}}}};
}

std::string form_text(const MeasureReport& report) {
  const FormAtDraft& f = report.form;
  std::string text = text_table({{"form", "", ""},
                                 {"prismatic coefficient C_P", decimals(f.prismatic_coefficient, 4), ""},
                                 {"midship coefficient C_M", decimals(f.midship_coefficient, 4), ""},
                                 {"TPC", decimals(f.tonnes_per_cm, 2), "t/cm"},
                                 {"MCT", decimals(f.moment_to_trim, 1), "t m/cm"},
                                 {"LCB from half the length, forward +", decimals(f.lcb_percent, 2), "% L"},
                                 {"LCF from half the length, forward +", decimals(f.lcf_percent, 2), "% L"}});
  if (report.draft_for_displacement.tonnes > 0.0)
    text += "the hull displaces " + decimals(report.draft_for_displacement.tonnes, 1) + " t at a draft of " +
            decimals(report.draft_for_displacement.draft, 4) + " m\n";
  return text;
}

std::string stations_text(const WaterlineAngles& line, const char* name) {
  std::vector<std::vector<std::string>> rows = {
      {std::string(name) + " ice waterline, z = " + decimals(line.z, 3) + " m", "x, m", "y, m", "waterline",
       "buttock", "flare", "normal flare", "plate slope", "+-"}};
  for (const StationAngles& s : line.stations)
    rows.push_back({decimals(100.0 * s.share, 1) + " % of the bow", decimals(s.at.x(), 2),
                    decimals(s.at.y(), 2), decimals(degrees(s.waterline), 2), decimals(degrees(s.buttock), 2),
                    decimals(degrees(s.flare), 2), decimals(degrees(s.normal_flare), 2),
                    decimals(degrees(s.plate_slope), 2), decimals(degrees(s.spread), 2)});
  return text_table(rows);
}

Json measure_json(const MeasureReport& report) {
  const HullMeasurement& hull = report.hull.measured;
  const MeshCheck check = check_mesh(report.hull.mesh);
  Json json = {{"mesh", {{"points", check.points}, {"quads", check.quads}, {"triangles", check.triangles}}},
               {"P0_m", point_json(hull.P0)},
               {"P1_m", point_json(hull.P1)},
               {"stem_m", report.hull.stem},
               {"stem_radius_m", hull.stem_radius},
               {"bow_length_m", number(report.hull.Lf)},
               {"repairs", in_words(report.hull.repairs)},
               {"warnings", report.hull.repairs.warnings},
               {"rules", rules_json(report)},
               {"hydrostatics", hydrostatics_json(report.hydrostatics)}};
  json["form"] = {
      {"C_P", number(report.form.prismatic_coefficient)}, {"C_M", number(report.form.midship_coefficient)},
      {"TPC_t_cm", number(report.form.tonnes_per_cm)},    {"MCT_tm_cm", number(report.form.moment_to_trim)},
      {"LCB_percent_L", number(report.form.lcb_percent)}, {"LCF_percent_L", number(report.form.lcf_percent)}};
  json["shell"] = shell_json(report.shell);
  if (report.draft_for_displacement.tonnes > 0.0)
    json["draft_for_displacement"] = {{"displacement_t", report.draft_for_displacement.tonnes},
                                      {"draft_m", report.draft_for_displacement.draft}};
  for (const Size& s : sizes(report)) json["dimensions"][s.key] = s.metres;
  for (const NamedAngle& a : angles(hull)) {
    json["angles_deg"][a.key] = number(degrees(a.angle));
    json["angles_spread_deg"][a.key] = number(std::isfinite(a.angle) ? degrees(a.spread) : a.angle);
  }
  json["stations"] = stations_json(report.upper, "upper");
  for (Json& row : stations_json(report.lower, "lower")) json["stations"].push_back(std::move(row));
  return json;
}

std::string measure_text(const MeasureReport& report) {
  const HullMeasurement& hull = report.hull.measured;
  std::string text;
  for (const std::string& words : in_words(report.hull.repairs)) text += "repaired: " + words + "\n";
  for (const std::string& words : report.hull.repairs.warnings) text += "warning: " + words + "\n";
  text += "the stem is at " + decimals(report.hull.stem, 3) + " m along the file's forward axis";
  if (hull.stem_radius > 0.0) text += ", with a radius of " + decimals(hull.stem_radius, 3) + " m";
  std::vector<std::vector<std::string>> rows = {{"dimensions", "m"}};
  for (const Size& s : sizes(report)) rows.push_back({s.name, decimals(s.metres, 3)});
  text += "\n\n" + text_table(rows);
  rows = {{"angle", "deg", "+-"}};
  for (const NamedAngle& a : angles(hull))
    rows.push_back({a.name, decimals(degrees(a.angle), 3), decimals(degrees(a.spread), 3)});
  const auto place = [](const Vec3& p) { return "(" + decimals(p.x(), 3) + ", " + decimals(p.y(), 3) + ")"; };
  return text + "\n" + text_table(rows) + "P0 at (x, y) = " + place(hull.P0) + " m, P1 at " + place(hull.P1) +
         " m on the waterline\n\n" + stations_text(report.upper, "upper") + "\n" +
         stations_text(report.lower, "lower") + "\n" + form_text(report) + shell_text(report.shell) + "\n" +
         hydrostatics_text(report.hydrostatics);
}

constexpr double sea_water = 1025.0;         //!< [kg/m^3]
constexpr double lower_ice_waterline = 0.8;  // of the draft, where none is given

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
  frame.unit = unit_option(arguments) * number_option(arguments, "--factor", 1.0, 1e-4, 1e4, "");
  frame.waterline = number_option(arguments, "--waterline", 0.0, -1e3, 1e3, "m");
  frame.draft = number_option(arguments, "--draft", 0.0, 1e-3, 1e3, "m");
  frame.left_handed = arguments.has("--left-handed");
  if (arguments.has("--draft") && arguments.has("--waterline"))
    throw InputError("--draft and --waterline both say where the waterline is: give one of them");
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

// For a person who waits at a terminal; nothing where the output goes to a file.
ImportProgress progress() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [last = std::string()](const std::string& stage, double share) mutable {
    const std::string words =
        stage + (share > 0.0 ? " " + std::to_string(static_cast<int>(100.0 * share)) + " %" : "");
    if (words != last) std::cerr << "\r\033[K" << words << std::flush;
    last = words;
  };
}

// The files asked for; refused before the hull is read where they could not be written.
void check_outputs(const Arguments& arguments) {
  const auto require = [&](const char* option, const std::vector<std::string>& endings) {
    if (!arguments.has(option)) return;
    const std::string path = arguments.value(option), ending = ending_of(path);
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
      throw InputError(std::string(option) + " " + path + ": the name must end in " + listed(endings));
    if (ending == ".pdf" && !why_no_pdf().empty())
      throw InputError(std::string(option) + " " + path + ": " + why_no_pdf());
  };
  require("--curves", {".svg", ".pdf", ".csv"});
  require("--offsets", {".csv"});
  require("--dxf", {".dxf"});
}

std::string curves_csv(const std::vector<FormAtDraft>& curves) {
  std::string out =
      "draft_m,volume_m3,displacement_t,LCB_percent_L,LCF_percent_L,KB_m,KM_T_m,TPC_t_cm,MCT_tm_cm,wetted_m2,"
      "C_B,C_P,C_M,C_W\n";
  for (const FormAtDraft& f : curves) {
    const Hydrostatics& h = f.values;
    out += text("%.6g,%.8g,%.8g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.8g,%.6g,%.6g,%.6g,%.6g\n", h.draft, h.volume,
                h.displacement / 1e3, f.lcb_percent, f.lcf_percent, h.KB, h.KM_T, f.tonnes_per_cm,
                f.moment_to_trim, h.wetted_area, h.block_coefficient, f.prismatic_coefficient,
                f.midship_coefficient, h.waterplane_coefficient);
  }
  return out;
}

CurvesPage curves_page(const MeasureReport& report, const Arguments& arguments, double density) {
  const ImportedHull& hull = report.hull;
  CurvesPage page;
  page.title = std::filesystem::path(hull.file).stem().string();
  page.water_density = density;
  page.KG = number_option(arguments, "--kg", 0.0, 0.0, 10.0 * hull.D, "m");
  page.curves =
      curves_of_form(hull.mesh, 0.1 * hull.T, std::min(1.2 * hull.T, 0.5 * (hull.T + hull.D)), 23, density);
  page.at_draft = form_at(hull.mesh, 0.0, density);
  std::vector<double> heels;
  for (int k = 0; k <= 12; ++k) heels.push_back(radians(5.0 * k));
  page.levers = righting_levers(hull.mesh, 0.0, heels);
  return page;
}

void write_outputs(const MeasureReport& report, const Arguments& arguments, double density) {
  if (arguments.has("--curves")) {
    const std::string path = arguments.value("--curves"), ending = ending_of(path);
    const CurvesPage page = curves_page(report, arguments, density);
    if (ending == ".pdf")
      write_pdf(path, curves_page_svg(page, DrawnFor::print), page.title);
    else
      write_text_file(path, ending == ".svg" ? curves_page_svg(page) : curves_csv(page.curves));
  }
  if (arguments.has("--offsets"))
    write_text_file(arguments.value("--offsets"), offsets_csv(offsets_of(report.hull.mesh)));
  if (arguments.has("--dxf")) write_text_file(arguments.value("--dxf"), lines_dxf(report.hull.mesh));
}

// Of the ice waterlines the upper one is the waterline itself.
double lower_waterline(const Arguments& arguments, double draft) {
  const double height = number_option(arguments, "--lower-draft", lower_ice_waterline * draft, 1e-3 * draft,
                                      draft, "m (the draft)");
  return height - draft;
}

}  // namespace

int run_measure(const Communicator&, const Arguments& arguments) {
  const std::string path = arguments.positional;
  const MeshFrame frame = frame_options(arguments);
  const double density = number_option(arguments, "--density", sea_water, 500.0, 1500.0, "kg/m3");
  const double tonnes = number_option(arguments, "--displacement", 0.0, 1e-3, 1e7, "t");
  check_outputs(arguments);
  MeasureReport report;
  report.hull = import_hull(path, frame, {arguments.has("--mirror"), arguments.has("--outer"), progress()});
  const QuadMesh& mesh = report.hull.mesh;
  if (isatty(STDERR_FILENO) != 0) std::cerr << "\r\033[K" << std::flush;
  // The draft of an even keel is the same everywhere: x only says where trim would turn.
  report.hydrostatics = hydrostatics_report(mesh, {}, density);
  report.upper = angles_along_waterline(mesh, 0.0, report.hull.on_chords);
  report.lower =
      angles_along_waterline(mesh, lower_waterline(arguments, report.hull.T), report.hull.on_chords);
  report.form = form_at(mesh, 0.0, density);
  report.shell = forebody_shell(mesh, report.hull.L, report.hull.B);
  if (tonnes > 0.0) report.draft_for_displacement = {tonnes, draft_for_volume(mesh, 1e3 * tonnes / density)};
  write_outputs(report, arguments, density);
  if (arguments.has("--json")) {
    std::cout << json_text(measure_json(report), 2) << "\n";
  } else {
    std::cout << path << ": " << mesh.quads.size() << " panels, closed, free of self-intersections\n"
              << measure_text(report);
  }
  return exit_code::ok;
}

}  // namespace icebow
