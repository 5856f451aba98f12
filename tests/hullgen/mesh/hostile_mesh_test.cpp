// Mesh files that are damaged or made to harm: each is refused in words, at once, by what its bytes can hold.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "hullgen/mesh/mesh_import.h"

using namespace icebow;

namespace {

struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "icebow_hostile_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
};

QuadMesh read(const char* name, const std::string& content) {
  const Scratch scratch;
  const std::string file = (scratch.path / name).string();
  write_text_file(file, content);
  MeshRepairs repairs;
  return read_mesh(file, repairs);
}

std::string refusal(const char* name, const std::string& content) {
  try {
    read(name, content);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <class T>
void add(std::string& out, T value, bool swapped = false) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out += swapped ? std::string(std::reverse_iterator(bytes + sizeof value), std::reverse_iterator(bytes))
                 : std::string(bytes, sizeof value);
}

const std::string points = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string tetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string panels = "element face 4\nproperty list uchar int vertex_indices\n";

std::string ply(const std::string& header, const std::string& body, const char* format = "ascii") {
  return "ply\nformat " + std::string(format) + " 1.0\n" + header + "end_header\n" + body;
}

std::string binary(bool big) {
  std::string body;
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int f[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& row : p)
    for (const float x : row) add(body, x, big);
  for (const auto& row : f) {
    body += '\3';
    for (const int k : row) add(body, k, big);
  }
  return ply(points + panels, body, big ? "binary_big_endian" : "binary_little_endian");
}

}  // namespace

TEST_CASE("a PLY header of four lines that has crashed readers is refused with its line") {
  CHECK_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n"),
             Catch::Contains("a.ply, line 3") && Catch::Contains("before the first element"));
}

TEST_CASE("a PLY file is not believed beyond its bytes") {
  const std::string body = tetrahedron + "3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  CHECK_THAT(refusal("a.ply", ply(points + "element face 1\nproperty list int int vertex_indices\n",
                                  tetrahedron + "2147483647 0 1 2\n")),
             Catch::Contains("row 1 of element \"face\"") && Catch::Contains("2147483647"));
  CHECK_THAT(refusal("a.ply", ply(points + "element face 1\nproperty list int int vertex_indices\n",
                                  tetrahedron + "-1\n")),
             Catch::Contains("list of -1"));
  CHECK_THAT(refusal("a.ply", ply("element vertex 18446744073709551615\nproperty float x\n", "")),
             Catch::Contains("announces 18446744073709551615 rows"));
  CHECK_THAT(refusal("a.ply", ply("element vertex 1000000000\n", "")), Catch::Contains("without a property"));
  CHECK_THAT(refusal("a.ply", ply("element junk 1000000000\nproperty list char int a\n", body)),
             Catch::Contains("announces"));
  CHECK_THAT(refusal("a.ply", ply(points + panels, body)),
             Catch::Contains("row 4") && Catch::Contains("ends here"));
  std::string cut = binary(false);
  cut.resize(cut.size() - 3);
  CHECK_THAT(refusal("a.ply", cut), Catch::Contains("row 4") && Catch::Contains("rest of the file"));
  std::string list = ply(points + "element face 1\nproperty list uint int vertex_indices\n",
                         std::string(48, '\0'), "binary_little_endian");
  add(list, std::uint32_t{4294967295u});
  CHECK_THAT(refusal("a.ply", list), Catch::Contains("4294967295"));
}

TEST_CASE("a PLY header of other types than the reader's is read by its types, or refused") {
  const std::string body = tetrahedron + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  CHECK(read("a.ply", ply("element vertex 4\nproperty int x\nproperty short y\nproperty double z\n"
                          "element face 4\nproperty list short ushort vertex_index\n",
                          body))
            .quads.size() == 4);
  CHECK_THAT(refusal("a.ply", ply("element vertex 4\nproperty list uchar float x\n" + panels, body)),
             Catch::Contains("no coordinate \"x\""));
  CHECK_THAT(refusal("a.ply", ply(points + "element face 4\nproperty int vertex_indices\n", body)),
             Catch::Contains("no list \"vertex_indices\""));
  CHECK_THAT(refusal("a.ply", ply("element vertex 4\nproperty half x\n", body)), Catch::Contains("\"half\""));
  CHECK_THAT(refusal("a.ply", ply(points + "element face 1\nproperty list float int vertex_indices\n", body)),
             Catch::Contains("whole numbers"));
  CHECK_THAT(refusal("a.ply", ply(points + panels, tetrahedron + "3 0 2 one\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")),
             Catch::Contains("row 1") && Catch::Contains("\"one\""));
  CHECK_THAT(refusal("a.ply", ply(points + panels, tetrahedron + "3 0 2 -1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")),
             Catch::Contains("names the point -1"));
  CHECK_THAT(refusal("a.ply", "ply\nformat ascii 1.0\n" + std::string(3 << 20, 'x')),
             Catch::Contains("end_header"));
}

TEST_CASE("PLY of both byte orders, with panels before points, and in strips") {
  CHECK(read("a.ply", binary(false)).quads == read("a.ply", binary(true)).quads);
  CHECK(read("a.ply", binary(true)).points[3] == Vec3(0, 0, 1));
  CHECK(read("a.ply", ply(panels + points, "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n" + tetrahedron))
            .quads.size() == 4);
  const QuadMesh strips =
      read("a.ply", ply(points + "element tristrips 1\nproperty list int int vertex_indices\n",
                        tetrahedron + "8 0 1 2 3 -1 0 2 1\n"));
  REQUIRE(strips.quads.size() == 3);
  CHECK(strips.quads[1] == std::array<int, 4>{2, 1, 3, 3});  // every second triangle of a strip is turned
}

TEST_CASE("an STL file that announces more triangles than it holds is refused with both numbers") {
  std::string stl(80, ' ');
  add(stl, std::uint32_t{4294967295u});
  stl += std::string(2 * 50, '\0');
  CHECK_THAT(refusal("a.stl", stl),
             Catch::Contains("announces 4294967295") && Catch::Contains("bytes for 2"));
}

TEST_CASE("a word of a hostile file is quoted in part, and printable") {
  const std::string message =
      refusal("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 \x1b[2J" + std::string(100000, '9') + "\n");
  CHECK(message.size() < 400);
  CHECK(message.find('\x1b') == std::string::npos);
}

TEST_CASE("a pipe or a directory in the place of a mesh is called what it is, at once") {
  const Scratch scratch;
  MeshRepairs repairs;
  const std::string pipe = (scratch.path / "a.ply").string(), folder = (scratch.path / "a.obj").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::filesystem::create_directory(folder);
  CHECK_THROWS_WITH(read_mesh(pipe, repairs), Catch::Contains(pipe) && Catch::Contains("is a pipe"));
  CHECK_THROWS_WITH(read_mesh(folder, repairs), Catch::Contains(folder) && Catch::Contains("is a directory"));
}

TEST_CASE("a panel that touches itself is split or refused; it does not take all of the memory") {
  for (const char* obj : {"v 0 0 0\nv 0 2 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nf 1 2 3 4 5\n",
                          "v 0 0 0\nv 0 0 0\nv 11 099999999999 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3 4 5\n",
                          "v 0 0 0\nv 1 0 5\nv 1 2 0\nv 1 2 1\nv 0 1 8\nf 1 2 3 4 5\n"}) {
    const std::string said = refusal("a.obj", obj);
    CHECK((said.empty() || said.find("crosses itself") != std::string::npos));
  }
}
