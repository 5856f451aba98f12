#include "hullgen/mesh/mesh_io.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "base/errors.h"
#include "base/json.h"
#include "geometry/triangles.h"
#include "hullgen/bow/bow.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/read_obj.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

const QuadMesh& hull() {
  static const QuadMesh mesh = [] {
    BowParameters bow = thyssen_waas_bow();
    bow.panel = bow.B / 10.0;
    return make_hull(bow).mesh;
  }();
  return mesh;
}

// A directory of its own, gone at the end.
struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "icebow_mesh_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
};

// The numbers between two marks of a text.
template <class T>
std::vector<T> numbers(const std::string& words, const std::string& from, const std::string& to) {
  const std::size_t begin = words.find(from) + from.size();
  std::istringstream stream(words.substr(begin, words.find(to, begin) - begin));
  std::vector<T> values;
  for (T value; stream >> value;) values.push_back(value);
  return values;
}

}  // namespace

TEST_CASE("OBJ keeps points, panels and patches to the last bit") {
  const Scratch scratch;
  write_mesh(scratch.file("hull.obj"), hull());
  MeshRepairs repairs;
  const QuadMesh read = read_mesh(scratch.file("hull.obj"), repairs);
  CHECK(repairs.split == 0);
  REQUIRE(read.points.size() == hull().points.size());
  for (std::size_t k = 0; k < read.points.size(); ++k) CHECK(read.points[k] == hull().points[k]);
  CHECK(read.quads == hull().quads);
  CHECK(read.patch == hull().patch);
  const std::string words = read_text_file(scratch.file("hull.obj"));
  CHECK(words.find("metres") < words.find("\nv "));
  CHECK(words.find("x forward, y to port, z up") < words.find("\nv "));
}

TEST_CASE("PLY keeps everything too") {
  const Scratch scratch;
  write_mesh(scratch.file("hull.ply"), hull());
  const std::string words = read_text_file(scratch.file("hull.ply"));
  CHECK(words.rfind("ply\nformat ascii 1.0\ncomment icebow hull; lengths in metres", 0) == 0);
  std::istringstream body(words.substr(words.find("end_header\n") + 11));
  for (const Vec3& p : hull().points) {
    Vec3 q;
    body >> q.x() >> q.y() >> q.z();
    REQUIRE(q == p);
  }
  for (std::size_t k = 0; k < hull().quads.size(); ++k) {
    int n = 0, corner = 0, patch = -1;
    body >> n;
    REQUIRE(n == (hull().is_triangle(k) ? 3 : 4));
    for (int c = 0; c < n; ++c) {
      body >> corner;
      REQUIRE(corner == hull().quads[k][c]);
    }
    body >> patch;
    REQUIRE(patch == static_cast<int>(hull().patch[k]));
  }
}

TEST_CASE("binary STL has the triangles, with outward normals") {
  const Scratch scratch;
  write_mesh(scratch.file("hull.stl"), hull());
  const std::string bytes = read_text_file(scratch.file("hull.stl"));
  CHECK(bytes.rfind("icebow hull; metres", 0) == 0);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  REQUIRE(count == triangles(hull()).size());
  REQUIRE(bytes.size() == 84 + 50 * static_cast<std::size_t>(count));
  double volume = 0.0;
  for (std::uint32_t k = 0; k < count; ++k) {
    float f[12];
    std::memcpy(f, bytes.data() + 84 + 50 * k, 48);
    const Eigen::Map<const Eigen::Matrix<float, 3, 4>> facet(f);
    const Eigen::Matrix<double, 3, 4> p = facet.cast<double>();
    const Vec3 twice_area = (p.col(2) - p.col(1)).cross(p.col(3) - p.col(1));
    CHECK(p.col(0).dot(twice_area) ==
          Approx(twice_area.norm()).epsilon(1e-3));  // single precision of the corners of small panels
    volume += p.col(1).dot(twice_area) / 6.0;
  }
  CHECK(volume == Approx(enclosed_volume(hull())).epsilon(1e-4));  // single precision
}

TEST_CASE("VTP has points, connectivity, offsets and patches") {
  const Scratch scratch;
  write_mesh(scratch.file("hull.vtp"), hull());
  const std::string words = read_text_file(scratch.file("hull.vtp"));
  const auto points = numbers<double>(words, "NumberOfComponents=\"3\" format=\"ascii\">", "</DataArray>");
  const auto corners = numbers<int>(words, "Name=\"connectivity\" format=\"ascii\">", "</DataArray>");
  const auto ends = numbers<int>(words, "Name=\"offsets\" format=\"ascii\">", "</DataArray>");
  const auto patches = numbers<int>(words, "Name=\"patch\" format=\"ascii\">", "</DataArray>");
  REQUIRE(points.size() == 3 * hull().points.size());
  REQUIRE(ends.size() == hull().quads.size());
  REQUIRE(patches.size() == hull().quads.size());
  REQUIRE(ends.back() == static_cast<int>(corners.size()));
  for (std::size_t k = 0; k < hull().points.size(); ++k)
    REQUIRE(hull().points[k] == Vec3(points[3 * k], points[3 * k + 1], points[3 * k + 2]));
  for (std::size_t k = 0, at = 0; k < ends.size(); ++k) {
    REQUIRE(patches[k] == static_cast<int>(hull().patch[k]));
    for (int c = 0; at < static_cast<std::size_t>(ends[k]); ++c, ++at)
      REQUIRE(corners[at] == hull().quads[k][c]);
  }
}

TEST_CASE("what cannot be written or read is named") {
  const Scratch scratch;
  CHECK_THROWS_AS(write_mesh(scratch.file("hull.step"), hull()), InputError);
  try {
    write_mesh(scratch.file("missing/hull.obj"), hull());
    FAIL("no error");
  } catch (const RuntimeError& error) {
    CHECK(std::string(error.what()).find("missing/hull.obj") != std::string::npos);
  }
  write_text_file(scratch.file("bad.obj"), "v 0 0 0\nv 1 0 0\nf 1 2 7\n");
  try {
    read_obj(scratch.file("bad.obj"));
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("bad.obj, line 3") != std::string::npos);
  }
  CHECK_THROWS_AS(read_obj(scratch.file("absent.obj")), InputError);
}
