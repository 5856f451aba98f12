// Stands in front of cad_import.cpp, which is loaded with OpenCASCADE when a file is first read.
#include <filesystem>

#include "base/errors.h"
#include "base/plugin.h"
#include "hullgen/cad/cad_import.h"
#include "hullgen/mesh/mesh_io.h"

namespace icebow {

bool is_cad_file(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".step" || ending == ".stp" || ending == ".igs" || ending == ".iges";
}

QuadMesh read_cad(const std::string& path, std::vector<std::string>& notes) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": no such file");
  using Read = void (*)(const std::string&, bool, std::vector<std::string>&, QuadMesh&);
  static const auto read = reinterpret_cast<Read>(plugin_function("libicebow_cad.so", "icebow_read_cad"));
  const std::string ending = ending_of(path);
  QuadMesh mesh;
  read(path, ending == ".step" || ending == ".stp", notes, mesh);
  return mesh;
}

}  // namespace icebow
