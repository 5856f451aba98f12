// What programs write as OBJ, STL and PLY: legal files are read, the others refused with cause and line.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/json.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/mesh_io.h"
#include "tests/support/scratch.h"

using namespace icebow;

namespace {

QuadMesh read(const std::string& name, const std::string& content, MeshRepairs* repairs = nullptr) {
  const Scratch scratch("reader");
  const std::string file = scratch.path() + "/" + name;
  std::ofstream(file, std::ios::binary) << content;
  MeshRepairs own;
  return read_mesh(file, repairs ? *repairs : own);
}

std::string refusal(const std::string& name, const std::string& content) {
  try {
    read(name, content);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string panels = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string facet(const char* a, const char* b, const char* c) {
  return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}
const std::string facets = facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", "0 0 1") +
                           facet("1 0 0", "0 1 0", "0 0 1") + facet("0 1 0", "0 0 0", "0 0 1");

std::string binary(std::uint32_t announced, int triangles, const char* head = "") {
  std::string out = head;
  out.resize(80, ' ');
  out.append(reinterpret_cast<const char*>(&announced), 4);
  for (int k = 0; k < triangles; ++k) {
    const float v[12] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, static_cast<float>(k)};
    out.append(reinterpret_cast<const char*>(v), sizeof v);
    out.append(2, '\0');
  }
  return out;
}

}  // namespace

TEST_CASE("OBJ as programs write it") {
  const std::array<int, 4> first = {0, 2, 1, 1};
  for (const std::string& legal : std::vector<std::string>{
           points + panels, panels + points, "\xEF\xBB\xBF" + points + panels, points + "f 1 3 2 # a panel\n",
           points + "f 1 \\\n 3 \\\n2\n", points + "f 1/1 3/2/2 2//5\n", points + "f -4 -2 -3\n",
           "v 0 0 0 1\nv 1 0 0 1.0\nv +0.0e0 1 0\nv 0 0 1 0.5 0.5 0.5\nf 1 3 2\n",
           "v 0 \\\n0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n",
           points + "l 1 2\np 3\no name\ns off\nusemtl red\nvn 0 0 1\nvt 0 0\nf 1 3 2\n",
           "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 3 2\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 3 2\r"}) {
    INFO(legal);
    CHECK(read("a.obj", legal).quads.at(0) == first);
  }
  CHECK(read("A.OBJ", points + panels).quads.size() == 4);
  const auto refused = [](const std::string& content, const std::string& line, const std::string& cause) {
    INFO(content);
    CHECK_THAT(refusal("a.obj", content), Catch::Contains("a.obj" + line) && Catch::Contains(cause));
  };
  refused(points + "f 1 2x 3\n", ", line 5", "no whole number");
  refused(points + "f 1 2.5 3\n", ", line 5", "no whole number");
  refused(points + "f 1 \\ 3\n", ", line 5", "no whole number");
  refused(points + "f 1 2 0\n", ", line 5", "give 1 to 4");
  refused(points + "f 1 2 5\n" + panels, ", line 5", "4 points");
  refused(points + "f -5 1 2\n", ", line 5", "-1 to -4");
  refused("v 0 0\n", ", line 1", "three numbers");
  refused("v 0 0 zero\n", ", line 1", "no");
  refused("v 0 0 nan\n", ", line 1", "finite");
  refused("v 0,5 1,5 2,5\n", ", line 1", "comma");
  refused(points + "cstype bspline\ndeg 3 3\n", ", line 5", "free-form");
  refused("", ":", "empty");
  refused(points, ":", "no panels");
  refused("# nothing\n", ":", "no OBJ mesh");
  refused(std::string("\xFF\xFEv\0 \0", 6), ":", "UTF-16");
}

TEST_CASE("STL in words, as programs write it") {
  const std::string lower = "solid a\n" + facets + "endsolid a\n";
  std::string upper = lower;
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  std::string commas = lower;
  for (std::size_t at = 0; (at = commas.find("vertex 1 0 0", at)) != std::string::npos;)
    commas.replace(at, 12, "vertex 1, 0, 0");
  for (const std::string& legal :
       std::vector<std::string>{lower, upper, commas, "\xEF\xBB\xBF" + lower, "solid a\n" + facets,
                                "solid facet of a ship\n" + facets + "endsolid\n",
                                "solid a\n" + facets.substr(0, facets.size() / 2) + "endsolid\nsolid b\n" +
                                    facets.substr(facets.size() / 2),
                                "  \n solid\n" + facets}) {
    INFO(legal);
    const QuadMesh mesh = read("a.stl", legal);
    CHECK(mesh.quads.size() == 4);
    CHECK(mesh.points.size() == 4);
  }
  CHECK(read("HULL.STL", lower).quads.size() == 4);
  const auto refused = [](const std::string& content, const std::string& line, const std::string& cause) {
    INFO(content);
    CHECK_THAT(refusal("a.stl", content), Catch::Contains("a.stl" + line) && Catch::Contains(cause));
  };
  refused("solid a\n" + facet("0 0 0", "1 0 nan", "0 1 0"), ", line 5", "finite");
  refused("solid a\n" + facet("0 0 0", "1,0000e0 0,0e0 0,0", "0 1 0"), ", line 5", "comma");
  refused("solid a\n" + facet("0 0 0", "1 0", "0 1 0"), ", line 6", "number");
  refused("solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", ", line", "cut off");
  refused(
      "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
      "0\nendloop\n",
      ", line", "4 corners");
  refused("solid a\nface normal 0 0 0\n", ", line 2", "\"face\"");
  refused("solid a\nendsolid a\n", ":", "no triangles");
  refused("", ":", "empty");
}

TEST_CASE("binary STL: the count must fit the size") {
  CHECK(read("a.stl", binary(4, 4)).quads.size() == 4);
  CHECK(read("a.stl", binary(4, 4, "solid by a program that says so in binary files too")).quads.size() == 4);
  MeshRepairs repairs;
  CHECK(read("a.stl", binary(0, 4), &repairs).quads.size() == 4);
  CHECK_THAT(repairs.notes.at(0), Catch::Contains("counts 0") && Catch::Contains("holds 4"));
  CHECK_THAT(refusal("a.stl", binary(7, 4)),
             Catch::Contains("announces 7") && Catch::Contains("bytes for 4"));
  CHECK_THAT(refusal("a.stl", binary(2, 4)),
             Catch::Contains("announces 2") && Catch::Contains("bytes for 4"));
  CHECK_THAT(refusal("a.stl", binary(4, 4).substr(0, 270)), Catch::Contains("bytes for 3 and a part of one"));
  std::string wild = binary(2, 2);
  const float nan = std::nanf("");
  std::memcpy(wild.data() + 84 + 12, &nan, sizeof nan);
  CHECK_THAT(refusal("a.stl", wild), Catch::Contains("triangle 1") && Catch::Contains("finite"));
}

TEST_CASE("a name's ending may come in capitals, for writing too") {
  const Scratch scratch("endings");
  const QuadMesh mesh = read("a.obj", points + panels);
  for (const char* name : {"/A.OBJ", "/A.Stl", "/A.PLY", "/A.VTP"})
    CHECK_NOTHROW(write_mesh(scratch.path() + name, mesh));
  MeshRepairs repairs;
  CHECK(read_mesh(scratch.path() + "/A.Stl", repairs).quads.size() == 4);
}

TEST_CASE("a long file says how far it is read") {
  std::string many = "solid a\n";
  for (int k = 0; k < 20000; ++k) many += facets;
  const Scratch scratch("progress");
  std::ofstream(scratch.path() + "/a.stl") << many;
  std::vector<double> shares;
  MeshRepairs repairs;
  read_mesh(scratch.path() + "/a.stl", repairs,
            [&](const std::string&, double share) { shares.push_back(share); });
  CHECK(shares.size() > 3);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() > 0.8);
}
