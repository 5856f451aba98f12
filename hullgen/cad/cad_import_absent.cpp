#include "base/errors.h"
#include "hullgen/cad/cad_file.h"
#include "hullgen/cad/cad_import.h"
#include "hullgen/mesh/mesh_io.h"

namespace icebow {

bool is_cad_file(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".step" || ending == ".stp" || ending == ".igs" || ending == ".iges";
}

QuadMesh read_cad(const std::string& path, std::vector<std::string>&) {
  throw InputError(path + ": " + why_no_cad());
}

}  // namespace icebow
