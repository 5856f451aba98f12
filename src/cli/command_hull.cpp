#include <cmath>
#include <iostream>

#include "base/errors.h"
#include "base/units.h"
#include "cli/bow_explanation.h"
#include "cli/commands.h"
#include "cli/hull_output.h"
#include "cli/hydrostatics_text.h"
#include "cli/number_option.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "study/evaluate/result_json.h"
#include "study/plan/nearest_feasible.h"
#include "study/spec/case_hull.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

// A drawing is named after the study, and after the design where it is not the study's own.
std::string drawing_title(const StudySpec& spec, const ChosenDesign& chosen) {
  return spec.name + (chosen.design.name == "baseline" ? "" : ": " + chosen.design.name);
}

std::string angle_rows(const Hull& hull, double stem_radius) {
  const BowAngles& asked = hull.requested;
  const bool measured = hull.status != HullStatus::infeasible;
  std::vector<std::vector<std::string>> rows = {{"angle, deg", "requested", "measured"}};
  const auto add = [&](const char* name, double wanted, double found) {
    rows.push_back({name, std::isfinite(wanted) ? decimals(degrees(wanted), 3) : "-",
                    measured ? decimals(degrees(found), 3) : "-"});
  };
  add("stem", asked.stem, hull.measured.stem);
  add("waterline", asked.waterline, hull.measured.waterline);
  add("buttock", asked.buttock, hull.measured.buttock);
  add("flare", asked.flare, hull.measured.flare);
  if (measured) {
    rows.push_back({"waterline at B/4", "", decimals(degrees(hull.waterline_at_quarter_beam), 3)});
    rows.push_back({"flare at the stem", "", decimals(degrees(hull.flare_at_stem), 3)});
    if (stem_radius > 0.0)
      rows.push_back({"stem radius, m", decimals(stem_radius, 3), decimals(hull.stem_radius, 3)});
  }
  return text_table(rows);
}

std::string margin_rows(const BowFeasibility& feasibility) {
  std::string text;
  for (const Margin& m : feasibility.margins) {
    const char* verdict = m.value >= 0.0 ? "  ok        " : m.required ? "  VIOLATED  " : "  (below 0) ";
    text += m.name + verdict + decimals(m.value, 3) + "  " + m.sentence + "\n";
  }
  return text;
}

std::string mesh_row(const Json& mesh) {
  if (mesh.is_null()) return "";
  const auto yes = [&](const char* key) { return mesh.at(key).get<bool>() ? "yes" : "no"; };
  return "mesh: " + mesh.at("quads").dump() + " quads, " + mesh.at("points").dump() + " points, closed " +
         yes("closed") + ", outward " + yes("outward") + ", self-intersecting " + yes("self_intersecting") +
         ", volume " +
         (mesh.at("volume_m3").is_number() ? decimals(mesh.at("volume_m3").get<double>(), 1) : "-") +
         " m3\n" + "quality: warp at most " + decimals(mesh.at("max_warp").get<double>(), 4) +
         " of a panel's edge, aspect ratio at most " + decimals(mesh.at("max_bow_aspect").get<double>(), 1) +
         " on the bow, " + decimals(mesh.at("max_aspect").get<double>(), 1) + " on the whole hull\n";
}

// Before the hull is made, like check_hull_output. The draft is amidships, at L/2 from the stem.
Flotation flotation(const Arguments& arguments, const BowParameters& bow) {
  for (const char* option : {"--draft", "--trim"}) {
    if (arguments.has(option) && !arguments.has("--hydrostatics"))
      throw InputError(std::string(option) + " is for --hydrostatics: give that too");
  }
  const double draft = number_option(arguments, "--draft", bow.T, 1e-3 * bow.D, bow.D, "m (the depth)");
  return {draft - bow.T, -bow.L / 2.0, radians(number_option(arguments, "--trim", 0.0, -45.0, 45.0, "deg"))};
}

}  // namespace

int run_hull(const Communicator&, const Arguments& arguments) {
  const std::string path = arguments.value("--out");
  check_hull_output(arguments);
  const StudySpec spec = load_study(arguments);
  const ChosenDesign chosen = choose_design(spec, arguments);
  const BowParameters& bow = chosen.description.bow;
  if (chosen.description.own.given() && is_surface_file(path))
    throw InputError(
        "--out " + path +
        ": surfaces are written of generated bows; this design's hull is an imported mesh: give a "
        "mesh's ending (.obj, .stl, .ply, .vtp)");
  const Flotation at = flotation(arguments, bow);
  const std::optional<OverlaidHull> overlaid = overlaid_hull(spec, arguments);
  const Hull hull = make_hull(chosen.description);
  Json json = hull_json(hull);
  json["design"] = chosen.design.name;
  std::string nearest;
  if (hull.status == HullStatus::infeasible && !chosen.description.own.given())
    nearest = nearest_feasible_words(bow, held_displacement(chosen.design.document));
  if (!nearest.empty()) json["nearest_feasible"] = nearest;
  if (chosen.description.own.given()) json["imported"] = imported_json(chosen.description.own);
  if (hull.status == HullStatus::ok && !path.empty())
    write_hull_output(path, hull, bow, drawing_title(spec, chosen), overlaid);
  std::string more;
  if (hull.status == HullStatus::ok) {
    const ShellShares shell = forebody_shell(hull.mesh, bow.L, bow.B);
    json["shell"] = shell_json(shell);
    more += shell_text(shell);
  }
  if (hull.status == HullStatus::ok && arguments.has("--hydrostatics")) {
    const HydrostaticsReport report = hydrostatics_report(hull.mesh, at, chosen.description.water.rho);
    json["hydrostatics"] = hydrostatics_json(report);
    more += "\n" + hydrostatics_text(report);
  }
  if (arguments.has("--explain")) {
    const bool generated = !chosen.description.own.given();  // an imported hull is of no family
    json["explanation"] = explanation_json(bow, generated);
    more += "\n" + explanation_text(bow, generated);
  }
  if (arguments.has("--json")) {
    std::cout << json_text(json, 2) << "\n";
  } else {
    std::cout << chosen.design.name << "\n\n"
              << angle_rows(hull, bow.centre.stem_radius) << "\n"
              << margin_rows(hull.feasibility) << mesh_row(json.at("mesh")) << more;
  }
  if (hull.status == HullStatus::ok) return exit_code::ok;
  std::cerr << chosen.design.name << ": no hull: " << json.at("reason").get<std::string>()
            << (nearest.empty() ? "" : "; ") << nearest << "\n";
  return exit_code::failure;
}

}  // namespace icebow
