// Hydrostatics as a person and as a program reads them.
#pragma once

#include "base/json.h"
#include "hullgen/hydro/hydrostatics.h"

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

}  // namespace icebow
