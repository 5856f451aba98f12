#include "hullgen/mesh_io.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "base/errors.h"
#include "base/json.h"
#include "hullgen/mesh_formats.h"
#include "hullgen/text.h"

namespace icebow {
namespace {

Patch patch_of(const std::string& name) {
  for (int k = 0; k < static_cast<int>(Patch::other); ++k)
    if (name == patch_name(static_cast<Patch>(k))) return static_cast<Patch>(k);
  return Patch::other;
}

// Reads one file line by line; every complaint names file and line.
class ObjReader {
 public:
  explicit ObjReader(const std::string& path) : path_(path), lines_(read_text_file(path)) {}

  QuadMesh read() {
    for (std::string line; std::getline(lines_, line);) {
      ++number_;
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "v") read_point(words);
      if (kind == "f") read_panel(words);
      if (kind == "g") words >> group_;
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const char* what) const {
    throw InputError(text("%s, line %d: %s", path_.c_str(), number_, what));
  }

  void read_point(std::istringstream& words) {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
      if (!(words >> p[k])) fail("a point needs three numbers");
    mesh_.points.push_back(p);
  }

  void read_panel(std::istringstream& words) {
    const int n = static_cast<int>(mesh_.points.size());
    std::vector<int> corners;
    for (std::string word; words >> word;) {  // "7" or "7/1/2": the first number is the point
      int corner = 0;
      std::from_chars(word.data(), word.data() + word.size(), corner);
      if (corner < 1 || corner > n) fail("a panel names a point that does not stand above it");
      corners.push_back(corner - 1);
    }
    if (corners.size() == 3) corners.push_back(corners.back());
    if (corners.size() != 4) fail("a panel needs three or four points");
    mesh_.quads.push_back({corners[0], corners[1], corners[2], corners[3]});
    mesh_.patch.push_back(patch_of(group_));
  }

  std::string path_, group_;
  std::istringstream lines_;
  int number_ = 0;
  QuadMesh mesh_;
};

}  // namespace

void write_mesh(const std::string& path, const QuadMesh& mesh) {
  const std::string ending = std::filesystem::path(path).extension().string();
  std::string (*format)(const QuadMesh&) = ending == ".obj"   ? obj_text
                                           : ending == ".ply" ? ply_text
                                           : ending == ".stl" ? stl_bytes
                                           : ending == ".vtp" ? vtp_text
                                                              : nullptr;
  if (!format)
    throw InputError(path + ": no such mesh format; the name must end in .obj, .ply, .stl or .vtp");
  write_text_file(path, format(mesh));
}

QuadMesh read_obj(const std::string& path) {
  return ObjReader(path).read();
}

}  // namespace icebow
