// A mesh file: refused in words, or a mesh whose corners exist. The first byte says which format.
#include <cstdlib>

#include "base/errors.h"
#include "hullgen/mesh/mesh_import.h"
#include "tests/fuzz/memory_file.h"

using namespace icebow;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const char* const endings[] = {".ply", ".obj", ".stl"};
  const std::string path = memory_file(endings[data[0] % 3], data + 1, size - 1);
  try {
    MeshRepairs repairs;
    const QuadMesh mesh = read_mesh(path, repairs);
    for (const auto& quad : mesh.quads)
      for (const int corner : quad)
        if (corner < 0 || corner >= static_cast<int>(mesh.points.size())) std::abort();
    for (const Vec3& p : mesh.points)
      if (!p.allFinite()) std::abort();
  } catch (const InputError&) {
  }
  return 0;
}
