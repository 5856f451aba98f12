// Stands in front of cad_file.cpp, which is loaded with OpenCASCADE when a file is first written.
#include "base/plugin.h"
#include "hullgen/cad/cad_file.h"

namespace icebow {

std::string why_no_cad() {
  return "";
}

double write_cad(const std::string& path, const HullSurfaces& hull, const std::string& name) {
  using Write = double (*)(const std::string&, const HullSurfaces&, const std::string&);
  static const auto write = reinterpret_cast<Write>(plugin_function("libicebow_cad.so", "icebow_write_cad"));
  return write(path, hull, name);
}

}  // namespace icebow
