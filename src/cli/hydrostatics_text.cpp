#include "cli/hydrostatics_text.h"

#include <algorithm>

#include "base/units.h"
#include "cli/text_table.h"
#include "study/evaluate/result_json.h"

namespace icebow {
namespace {

constexpr double straight_beams = 10.0;  // radius of curvature that counts as straight, in beams

constexpr int stations = 21;  // ten to the half length, as on a lines plan

}  // namespace

HydrostaticsReport hydrostatics_report(const QuadMesh& mesh, const Flotation& at, double water_density) {
  return {at, water_density, hydrostatics(mesh, at, water_density), sectional_areas(mesh, at, stations)};
}

std::string hydrostatics_text(const HydrostaticsReport& report) {
  const Hydrostatics& h = report.values;
  std::string text = text_table({
      {"hydrostatics", "", ""},
      {"draft amidships", decimals(h.draft, 3), "m"},
      {"trim by the stern", decimals(degrees(report.at.trim), 3), "deg"},
      {"length on the waterline", decimals(h.length, 3), "m"},
      {"beam on the waterline", decimals(h.beam, 3), "m"},
      {"volume", decimals(h.volume, 1), "m3"},
      {"displacement, " + decimals(report.water_density, 0) + " kg/m3", decimals(h.displacement / 1e3, 1),
       "t"},
      {"LCB (x, from the origin)", decimals(h.buoyancy.x(), 3), "m"},
      {"TCB (y)", decimals(h.buoyancy.y(), 3), "m"},
      {"KB", decimals(h.KB, 3), "m"},
      {"waterplane area", decimals(h.waterplane_area, 1), "m2"},
      {"LCF (x, from the origin)", decimals(h.flotation.x(), 3), "m"},
      {"second moment I_T", decimals(h.I_T, 0), "m4"},
      {"second moment I_L", decimals(h.I_L, 0), "m4"},
      {"wetted area", decimals(h.wetted_area, 1), "m2"},
      {"block coefficient", decimals(h.block_coefficient, 4), ""},
      {"waterplane coefficient", decimals(h.waterplane_coefficient, 4), ""},
      {"BM_T", decimals(h.BM_T, 3), "m"},
      {"BM_L", decimals(h.BM_L, 3), "m"},
      {"KM_T", decimals(h.KM_T, 3), "m"},
  });
  std::vector<std::vector<std::string>> rows = {{"x, m", "section, m2"}};
  for (const SectionArea& s : report.sections) rows.push_back({decimals(s.x, 2), decimals(s.area, 2)});
  return text + "\nsectional areas, aft to fore\n" + text_table(rows);
}

Json hydrostatics_json(const HydrostaticsReport& report) {
  Json json = hydrostatics_json(report.values);
  Json sections = Json::array();
  for (const SectionArea& s : report.sections) sections.push_back({{"x_m", s.x}, {"area_m2", s.area}});
  json["trim_deg"] = degrees(report.at.trim);
  json["water_density_kg_m3"] = report.water_density;
  json["sections"] = std::move(sections);
  return json;
}

ShellShares forebody_shell(const QuadMesh& mesh, double length, double beam) {
  return shell_shares(mesh, -0.5 * length, straight_beams * beam);
}

std::string shell_text(const ShellShares& shell) {
  const auto percent = [](double share) { return decimals(100.0 * share, 1) + " %"; };
  return "shell of the forebody under water: " + decimals(shell.area, 1) + " m2, flat " +
         percent(shell.flat) + ", single-curved " + percent(shell.single_curved) + ", curved both ways " +
         percent(shell.double_curved) + "\n";
}

Json shell_json(const ShellShares& shell) {
  return {{"forebody_wetted_m2", shell.area},
          {"flat_share", shell.flat},
          {"single_curved_share", shell.single_curved},
          {"double_curved_share", shell.double_curved}};
}

}  // namespace icebow
