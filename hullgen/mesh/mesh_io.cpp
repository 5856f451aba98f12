#include "hullgen/mesh/mesh_io.h"

#include <cctype>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_formats.h"

namespace icebow {
std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

void write_mesh(const std::string& path, const QuadMesh& mesh) {
  const std::string ending = ending_of(path);
  std::string (*format)(const QuadMesh&) = ending == ".obj"   ? obj_text
                                           : ending == ".ply" ? ply_text
                                           : ending == ".stl" ? stl_bytes
                                           : ending == ".vtp" ? vtp_text
                                                              : nullptr;
  if (!format)
    throw InputError(path + ": no such mesh format; the name must end in .obj, .ply, .stl or .vtp");
  write_text_file(path, format(mesh));
}

}  // namespace icebow
