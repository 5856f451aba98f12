#include "hullgen/mesh/mesh_io.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "base/errors.h"
#include "base/json.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_formats.h"

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

  PolygonMesh read() {
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

  // "7" or "7/1/2": the first number is the point. A negative one counts back from the last point so far.
  int corner(const std::string& word) const {
    const int n = static_cast<int>(mesh_.points.size());
    int k = 0;
    std::from_chars(word.data(), word.data() + word.size(), k);
    if (k < 0) k += n + 1;
    if (k < 1 || k > n)
      fail(text("a panel names the point %s, but %d points stand above it: give 1 to %d, or -1 to -%d",
                excerpt(word).c_str(), n, n, n)
               .c_str());
    return k - 1;
  }

  void read_panel(std::istringstream& words) {
    std::vector<int> corners;
    for (std::string word; words >> word;) corners.push_back(corner(word));
    if (corners.size() < 3) fail("a panel needs three points or more");
    mesh_.polygons.push_back(std::move(corners));
    mesh_.patch.push_back(patch_of(group_));
  }

  std::string path_, group_;
  std::istringstream lines_;
  int number_ = 0;
  PolygonMesh mesh_;
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

PolygonMesh read_obj(const std::string& path) {
  return ObjReader(path).read();
}

}  // namespace icebow
