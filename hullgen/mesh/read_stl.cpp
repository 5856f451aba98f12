#include "hullgen/mesh/read_stl.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "base/text.h"

namespace icebow {
namespace {

constexpr std::size_t header = 84, facet_bytes = 50;

struct SamePlace {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t h = 1469598103934665603u;
    for (double v : p) {
      std::uint64_t bits;
      std::memcpy(&bits, &v, sizeof bits);
      h = (h ^ bits) * 1099511628211u;
      h ^= h >> 29;
    }
    return h;
  }
};

class StlReader {
 public:
  StlReader(const std::string& path, const ImportProgress& progress) : bytes_(path, progress) {}

  PolygonMesh read() {
    is_text() ? read_text() : read_binary();
    if (mesh_.size() == 0) bytes_.fail_file("has no triangles: export the hull's surface again");
    return std::move(mesh_);
  }

 private:
  // A binary header may begin with "solid" too, so the size decides first, then whether a facet follows.
  bool is_text() {
    const std::string head = lower(bytes_.peek(1000));
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    const bool solid = first != std::string::npos && head.compare(first, 5, "solid") == 0;
    if (!solid) return false;
    if (bytes_.left() >= header && bytes_.left() == header + facet_bytes * announced()) return false;
    return std::all_of(head.begin(), head.end(), [](unsigned char c) { return c >= 9 && c != 127; });
  }
  static std::string lower(std::string word) {
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
  }
  std::uint64_t announced() {
    const std::string head = bytes_.peek(header);
    std::uint32_t n = 0;
    std::memcpy(&n, head.data() + 80, sizeof n);
    return n;
  }

  void add_corner(const std::array<double, 3>& p) {
    const auto [found, fresh] = numbers_.try_emplace(p, static_cast<int>(mesh_.points.size()));
    if (fresh) mesh_.points.push_back({p[0], p[1], p[2]});
    mesh_.corners.push_back(found->second);
  }

  std::string expect(const char* what) {
    std::string word;
    if (!bytes_.word(word))
      bytes_.fail(text("the file ends where \"%s\" should follow: it is cut off", what));
    return lower(word);
  }
  void require(const char* wanted) {
    const std::string word = expect(wanted);
    if (word != wanted) bytes_.fail(text("%s where \"%s\" should stand", excerpt(word).c_str(), wanted));
  }

  void read_vertex() {
    std::array<double, 3> p;
    for (double& v : p) v = bytes_.number(expect("a number")) + 0.0;
    add_corner(p);
  }

  void read_facet() {
    require("normal");
    for (int k = 0; k < 3; ++k) expect("a number");  // what the normal says the corners say too
    require("outer");
    require("loop");
    int corners = 0;
    std::string word = expect("vertex");
    for (; word == "vertex"; word = expect("endloop")) read_vertex(), ++corners;
    if (word != "endloop")
      bytes_.fail(text("%s where \"vertex\" or \"endloop\" should stand", excerpt(word).c_str()));
    if (corners != 3) bytes_.fail(text("a facet of %d corners: an STL file has triangles", corners));
    require("endfacet");
    mesh_.close_polygon(Patch::other);
  }

  void read_text() {
    for (std::string word; bytes_.word(word);) {
      const std::string kind = lower(word);
      if (kind == "solid" || kind == "endsolid") {
        bytes_.rest_of_line();
      } else if (kind == "facet") {
        read_facet();
      } else if (kind == "color") {
        for (int k = 0; k < 3; ++k) expect("a number");
      } else {
        bytes_.fail(text("%s where \"facet\" or \"endsolid\" should stand", excerpt(word).c_str()));
      }
    }
  }

  // How many triangles there are. A header that says otherwise is a file cut off, or not an STL file at all.
  std::uint64_t triangle_count() {
    if (bytes_.left() < header)
      bytes_.fail_file(
          "is no STL file: it neither begins with \"solid\" nor has the 84 bytes of a binary header");
    const std::uint64_t said = announced(), room = bytes_.left() - header, whole = room / facet_bytes;
    if (room == said * facet_bytes) return said;
    if (said == 0 && whole > 0 && room % facet_bytes == 0) {
      mesh_.notes.push_back(text("the header counts 0 triangles, the file holds %llu: all were read",
                                 static_cast<unsigned long long>(whole)));
      return whole;
    }
    bytes_.fail_file(
        text("its header announces %llu triangles, but the file has bytes for %llu%s: it is cut off, damaged "
             "or no "
             "STL file; export it again",
             static_cast<unsigned long long>(said), static_cast<unsigned long long>(whole),
             room % facet_bytes == 0 ? "" : " and a part of one"));
  }

  void read_binary() {
    const std::uint64_t n = triangle_count();
    char skipped[header];
    bytes_.read(skipped, header);
    mesh_.corners.reserve(3 * n);
    mesh_.ends.reserve(n);
    mesh_.patch.reserve(n);
    for (std::uint64_t k = 0; k < n; ++k) {
      char facet[facet_bytes];
      if (!bytes_.read(facet, facet_bytes)) bytes_.fail_at_place("the file is cut off");
      float v[9];
      std::memcpy(v, facet + 12, sizeof v);
      for (int c = 0; c < 9; c += 3) {
        if (!std::isfinite(v[c]) || !std::isfinite(v[c + 1]) || !std::isfinite(v[c + 2]))
          bytes_.fail_at_place(
              text("triangle %llu has a coordinate that is not a finite number: export the mesh again",
                   static_cast<unsigned long long>(k + 1)));
        add_corner({v[c] + 0.0, v[c + 1] + 0.0, v[c + 2] + 0.0});  // -0 becomes 0
      }
      mesh_.close_polygon(Patch::other);
    }
  }

  MeshBytes bytes_;
  PolygonMesh mesh_;
  std::unordered_map<std::array<double, 3>, int, SamePlace> numbers_;
};

}  // namespace

PolygonMesh read_stl(const std::string& path, const ImportProgress& progress) {
  return StlReader(path, progress).read();
}

}  // namespace icebow
