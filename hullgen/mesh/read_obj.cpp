#include "hullgen/mesh/read_obj.h"

#include <charconv>
#include <set>

#include "base/errors.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_formats.h"

namespace icebow {
namespace {

Patch patch_of(const std::string& name) {
  for (int k = 0; k < static_cast<int>(Patch::other); ++k)
    if (name == patch_name(static_cast<Patch>(k))) return static_cast<Patch>(k);
  return Patch::other;
}

// The words of a line, one after another.
class Words {
 public:
  explicit Words(const std::string& line) : line_(line) {}
  bool next(std::string& word) {
    const std::size_t from = line_.find_first_not_of(" \t\f\v", at_);
    if (from == std::string::npos) return false;
    at_ = std::min(line_.find_first_of(" \t\f\v", from), line_.size());
    word.assign(line_, from, at_ - from);
    return true;
  }

 private:
  const std::string& line_;
  std::size_t at_ = 0;
};

class ObjReader {
 public:
  ObjReader(const std::string& path, const ImportProgress& progress) : bytes_(path, progress) {}

  PolygonMesh read() {
    for (std::string line; joined_line(line);) read_line(line);
    check_corners();
    if (mesh_.size() == 0)
      bytes_.fail_file(mesh_.points.empty()
                           ? "is no OBJ mesh: it has no line \"v x y z\" and no line \"f 1 2 3\""
                           : "has points but no panels (lines \"f 1 2 3\"): export surfaces, not lines");
    return std::move(mesh_);
  }

 private:
  // With the lines a backslash joins to it, without its comment.
  bool joined_line(std::string& line) {
    if (!bytes_.line(line)) return false;
    first_line_ = bytes_.line_number();
    for (std::string more; ends_in_backslash(line);) {
      line.pop_back();
      if (!bytes_.line(more)) break;
      line += " " + more;
    }
    if (const std::size_t comment = line.find('#'); comment != std::string::npos) line.resize(comment);
    return true;
  }
  static bool ends_in_backslash(std::string& line) {
    const std::size_t last = line.find_last_not_of(" \t");
    if (last == std::string::npos || line[last] != '\\') return false;
    line.resize(last + 1);
    return true;
  }

  void read_line(const std::string& line) {
    static const std::set<std::string> free_form = {"cstype", "surf", "curv", "curv2", "deg",
                                                    "bmat",   "parm", "trim", "hole",  "scrv",
                                                    "bzp",    "bsp",  "cdc",  "cdp",   "res"};
    Words words(line);
    std::string kind;
    if (!words.next(kind)) return;
    if (kind == "v") {
      read_point(words);
    } else if (kind == "f" || kind == "fo") {
      read_panel(words);
    } else if (kind == "g") {
      group_.clear();
      words.next(group_);
    } else if (free_form.count(kind)) {
      bytes_.fail(
          excerpt(kind) +
          " belongs to a free-form surface, and panels are wanted: export the hull as a polygon mesh, or as "
          "STEP");
    } else if (kind == "call" || kind == "csh") {
      bytes_.fail(excerpt(kind) + " asks for another file: export the hull as one file");
    }
  }

  void read_point(Words& words) {
    Vec3 p;
    std::string word;
    for (int k = 0; k < 3; ++k) {
      if (!words.next(word)) bytes_.fail("a point needs three numbers");
      p[k] = bytes_.number(word);
    }
    mesh_.points.push_back(p);
  }

  [[noreturn]] void bad_corner(const std::string& word, int points) const {
    bytes_.fail(text("a panel names the point %s, but the file has %d points: give 1 to %d, or -1 to -%d",
                     excerpt(word).c_str(), points, points, points));
  }

  // "7" or "7/1/2": the first number is the point. One that counts back does so from the last point so far.
  int corner(const std::string& word) const {
    const int n = static_cast<int>(mesh_.points.size());
    int k = 0;
    const char* last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, k);
    if (error == std::errc::invalid_argument || (end != last && *end != '/'))
      bytes_.fail("a panel names the point " + excerpt(word) + ", which is no whole number");
    if (error != std::errc() || k == 0 || k < -n) bad_corner(word, n);
    return k < 0 ? k + n : k - 1;
  }

  void read_panel(Words& words) {
    const std::size_t before = mesh_.corners.size();
    for (std::string word; words.next(word);) {
      mesh_.corners.push_back(corner(word));
      if (mesh_.corners.back() > highest_) highest_ = mesh_.corners.back(), highest_line_ = first_line_;
    }
    if (mesh_.corners.size() < before + 3) bytes_.fail("a panel needs three points or more");
    mesh_.close_polygon(patch_of(group_));
  }

  // Points may stand below the panels that name them, so this is known at the end only.
  void check_corners() const {
    const int n = static_cast<int>(mesh_.points.size());
    if (highest_ < n) return;
    bytes_.fail_at_line(
        highest_line_,
        text("a panel names the point \"%d\", but the file has %d points: give 1 to %d, or -1 to -%d",
             highest_ + 1, n, n, n));
  }

  MeshBytes bytes_;
  std::string group_;
  PolygonMesh mesh_;
  int first_line_ = 0, highest_ = -1, highest_line_ = 0;
};

}  // namespace

PolygonMesh read_obj(const std::string& path, const ImportProgress& progress) {
  return ObjReader(path, progress).read();
}

}  // namespace icebow
