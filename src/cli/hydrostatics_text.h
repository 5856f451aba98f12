// Hydrostatics as a person and as a program reads them.
#pragma once

#include "base/json.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/hydro/shell_curvature.h"

namespace icebow {

struct HydrostaticsReport {
  Flotation at;
  double water_density = 0.0;  //!< [kg/m^3]
  Hydrostatics values;
  std::vector<SectionArea> sections;  // 21 stations
};

HydrostaticsReport hydrostatics_report(const QuadMesh& mesh, const Flotation& at, double water_density);

std::string hydrostatics_text(const HydrostaticsReport& report);
// Keys end in their unit; "sections" is the sectional area curve from aft to fore.
Json hydrostatics_json(const HydrostaticsReport& report);

// How much of the forebody's wetted shell, ahead of half the length, bends one way: a radius above ten beams
// counts as straight.
ShellShares forebody_shell(const QuadMesh& mesh, double length, double beam);
std::string shell_text(const ShellShares& shell);
Json shell_json(const ShellShares& shell);

}  // namespace icebow
