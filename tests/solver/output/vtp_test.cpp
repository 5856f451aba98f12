#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>

#include "base/errors.h"
#include "base/json.h"
#include "solver/output/vtp.h"
#include "tests/support/shapes.h"

using namespace icebow;

namespace {

std::size_t number(const std::string& text, const std::string& attribute) {
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex(attribute + "=\"([0-9]+)\"")));
  return std::stoul(match[1]);
}

// A reader of appended raw PolyData that trusts nothing: arrays must fill the appended section without gap or
// overlap.
struct PolyData {
  std::string xml;
  std::map<std::string, std::string> bytes;  // by "element/name"
  std::map<std::string, std::string> type;

  explicit PolyData(const std::string& path) {
    const std::string file = read_text_file(path), opening = "<AppendedData encoding=\"raw\">\n_";
    const std::string closing = "\n</AppendedData>\n</VTKFile>\n";
    const std::size_t head = file.find(opening);
    REQUIRE(head != std::string::npos);
    REQUIRE(file.substr(file.size() - closing.size()) == closing);
    xml = file.substr(0, head);
    const std::string data =
        file.substr(head + opening.size(), file.size() - closing.size() - head - opening.size());
    REQUIRE(xml.find("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"") == 0);
    REQUIRE(xml.find("byte_order=\"LittleEndian\" header_type=\"UInt64\"") != std::string::npos);
    read_arrays(data);
  }

  void read_arrays(const std::string& data) {
    const std::regex tag(
        "<(PointData|CellData|Points|Verts|Polys)>|<DataArray type=\"(\\w+)\" Name=\"(\\w+)\"[^>]*"
        "offset=\"([0-9]+)\"/>");
    std::string element;
    std::size_t expected = 0;
    for (std::sregex_iterator it(xml.begin(), xml.end(), tag), end; it != end; ++it) {
      if ((*it)[1].matched) {
        element = (*it)[1];
        continue;
      }
      const std::size_t offset = std::stoul((*it)[4]);
      REQUIRE(offset == expected);
      std::uint64_t size = 0;
      std::memcpy(&size, data.data() + offset, sizeof size);
      REQUIRE(offset + sizeof size + size <= data.size());
      bytes[element + "/" + (*it)[3].str()] = data.substr(offset + sizeof size, size);
      type[element + "/" + (*it)[3].str()] = (*it)[2];
      expected = offset + sizeof size + size;
    }
    REQUIRE(expected == data.size());
  }

  template <class T>
  std::vector<T> array(const std::string& name) const {
    REQUIRE(bytes.count(name) == 1);
    const std::string& raw = bytes.at(name);
    std::vector<T> values(raw.size() / sizeof(T));
    std::memcpy(values.data(), raw.data(), values.size() * sizeof(T));
    return values;
  }
};

struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("icebow_vtp_test" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
};

IceCloud three_particles() {
  IceCloud ice;
  ice.x = {1, 2, 3}, ice.y = {4, 5, 6}, ice.z = {7, 8, 9};
  ice.ux = {.1f, .2f, .3f}, ice.uy = {.4f, .5f, .6f}, ice.uz = {.7f, .8f, .9f};
  ice.damage = {0.0f, 0.5f, 1.0f};
  ice.piece = {0, 12, -1};
  ice.dx = 1;
  return ice;
}

}  // namespace

TEST_CASE("VTP: the particles come back") {
  const Folder folder;
  const IceCloud ice = three_particles();
  write_ice_vtp(folder.file("ice.vtp"), ice);
  const PolyData file(folder.file("ice.vtp"));
  CHECK(number(file.xml, "NumberOfPoints") == 3);
  CHECK(number(file.xml, "NumberOfVerts") == 3);
  CHECK(number(file.xml, "NumberOfPolys") == 0);
  CHECK(file.array<float>("Points/Points") == std::vector<float>{1, 4, 7, 2, 5, 8, 3, 6, 9});
  CHECK(file.array<float>("PointData/displacement_m") ==
        std::vector<float>{.1f, .4f, .7f, .2f, .5f, .8f, .3f, .6f, .9f});
  CHECK(file.array<float>("PointData/damage") == ice.damage);
  CHECK(file.array<std::int32_t>("PointData/piece") == ice.piece);
  CHECK(file.array<std::int32_t>("Verts/connectivity") == std::vector<std::int32_t>{0, 1, 2});
  CHECK(file.array<std::int32_t>("Verts/offsets") == std::vector<std::int32_t>{1, 2, 3});
  CHECK(file.type.at("PointData/damage") == "Float32");
  CHECK(file.type.at("PointData/piece") == "Int32");
  write_ice_vtp(folder.file("none.vtp"), {});
  CHECK(number(PolyData(folder.file("none.vtp")).xml, "NumberOfPoints") == 0);
}

TEST_CASE("VTP: velocities where there are some, and the file that names the ranks' pieces") {
  const Folder folder;
  IceCloud ice = three_particles();
  ice.vx = {1, 2, 3}, ice.vy = {4, 5, 6}, ice.vz = {7, 8, 9};
  write_ice_vtp(folder.file("ice_p0.vtp"), ice);
  CHECK(PolyData(folder.file("ice_p0.vtp")).array<float>("PointData/velocity_m_per_s") ==
        std::vector<float>{1, 4, 7, 2, 5, 8, 3, 6, 9});
  write_ice_pvtp(folder.file("ice.pvtp"), {"ice_p0.vtp", "ice_p1.vtp"}, true);
  const std::string text = read_text_file(folder.file("ice.pvtp"));
  for (const char* part : {"type=\"PPolyData\"", "<Piece Source=\"ice_p1.vtp\"/>",
                           "Name=\"velocity_m_per_s\"", "Name=\"crack\""})
    CHECK_THAT(text, Catch::Contains(part));
}

TEST_CASE("VTP: the hull keeps quads, triangles and patches, in its own frame") {
  const Folder folder;
  QuadMesh hull = shapes::box({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  hull.quads[1][3] = hull.quads[1][2];
  hull.patch[2] = Patch::deck;
  write_hull_vtp(folder.file("hull.vtp"), hull);
  const PolyData file(folder.file("hull.vtp"));
  CHECK(number(file.xml, "NumberOfPolys") == 6);
  CHECK(number(file.xml, "NumberOfPoints") == hull.points.size());
  const auto points = file.array<float>("Points/Points");
  const auto offsets = file.array<std::int32_t>("Polys/offsets");
  CHECK(offsets == std::vector<std::int32_t>{4, 7, 11, 15, 19, 23});
  const auto connectivity = file.array<std::int32_t>("Polys/connectivity");
  REQUIRE(connectivity.size() == 23);
  const auto corner = [&](int n) {
    return Vec3(points[3 * connectivity[n]], points[3 * connectivity[n] + 1],
                points[3 * connectivity[n] + 2]);
  };
  CHECK((corner(6) - hull.points[hull.quads[1][2]]).norm() < 1e-6);  // floats
  CHECK((corner(7) - hull.points[hull.quads[2][0]]).norm() < 1e-6);  // floats
  CHECK(file.array<std::uint8_t>("CellData/patch")[2] == static_cast<std::uint8_t>(Patch::deck));
}

TEST_CASE("VTP: pressed quads keep their number, corners, pressure and traction") {
  const Folder folder;
  const QuadMesh hull = shapes::box({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  write_pressure_vtp(folder.file("p.vtp"), hull, {{4, 2e5, Vec3(1e5, 0, -2e5)}});
  const PolyData file(folder.file("p.vtp"));
  CHECK(number(file.xml, "NumberOfPolys") == 1);
  CHECK(number(file.xml, "NumberOfPoints") == 4);
  CHECK(file.array<std::int32_t>("CellData/quad") == std::vector<std::int32_t>{4});
  CHECK(file.array<float>("CellData/ice_pressure_Pa") == std::vector<float>{2e5f});
  CHECK(file.array<float>("CellData/ice_traction_Pa") == std::vector<float>{1e5f, 0.0f, -2e5f});
  const auto points = file.array<float>("Points/Points");
  for (std::size_t corner = 0; corner < 4; ++corner)
    for (int c = 0; c < 3; ++c)
      CHECK(points[3 * corner + c] == static_cast<float>(hull.points[hull.quads[4][corner]][c]));
  write_pressure_vtp(folder.file("none.vtp"), hull, {});
  CHECK(number(PolyData(folder.file("none.vtp")).xml, "NumberOfPolys") == 0);
}

TEST_CASE("PVD: times in full precision, names escaped, rewritten whole") {
  const Folder folder;
  const std::string path = folder.file("ice.pvd");
  write_pvd(path, {{0.0, "ice_0000.vtp"}});
  write_pvd(path, {{0.0, "ice_0000.vtp"}, {0.1, "a&\"b.vtp"}});
  const std::string text = read_text_file(path);
  CHECK(text.find("<VTKFile type=\"Collection\"") != std::string::npos);
  CHECK(text.find("timestep=\"0\" group=\"\" part=\"0\" file=\"ice_0000.vtp\"") != std::string::npos);
  CHECK(text.find("timestep=\"0.10000000000000001\" group=\"\" part=\"0\" file=\"a&amp;&quot;b.vtp\"") !=
        std::string::npos);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("VTP: a file that cannot be written is named") {
  const std::string nowhere = "/nonexistent_folder/x.vtp";
  CHECK_THROWS_AS(write_ice_vtp(nowhere, three_particles()), RuntimeError);
  CHECK_THROWS_WITH(write_hull_vtp(nowhere, {}), Catch::Contains(nowhere));
  CHECK_THROWS_WITH(write_pvd(nowhere, {}), Catch::Contains(nowhere));
}
