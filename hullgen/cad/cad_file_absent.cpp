// Stands in for cad_file.cpp in a build without OpenCASCADE.
#include "base/errors.h"
#include "hullgen/cad/cad_file.h"

namespace icebow {

std::string why_no_cad() {
  return "this program was built without STEP and IGES (OpenCASCADE): install libocct-data-exchange-dev, "
         "configure "
         "with -DICEBOW_CAD=ON and build again, or write a mesh (.obj, .stl, .ply, .vtp)";
}

double write_cad(const std::string& path, const HullSurfaces&, const std::string&) {
  throw InputError(path + ": " + why_no_cad());
}

}  // namespace icebow
