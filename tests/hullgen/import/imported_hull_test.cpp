// A mesh file of somebody else becomes a hull with a stem, dimensions and angles.
#include "hullgen/import/imported_hull.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/mesh/mesh_check.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/mesh_io.h"

using namespace icebow;

namespace {

struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "icebow_import_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

BowParameters bow() {
  BowParameters b = preset_bow(BowFamily::concave);
  b.panel = b.B / 20.0;
  return b;
}

ImportedHull through_file(const QuadMesh& mesh, const std::string& name, const MeshFrame& frame = {},
                          bool mirror = false) {
  const Scratch scratch;
  write_mesh(scratch.file(name), mesh);
  return import_hull(scratch.file(name), frame, {mirror, false, {}});
}

// A box with a wedge of a bow, its deck one panel of six corners and its keel another.
const char* wedge = R"(v 0 0 -1
v -5 2 -1
v -20 2 -1
v -20 -2 -1
v -5 -2 -1
v 1 0 1
v -5 2 1
v -20 2 1
v -20 -2 1
v -5 -2 1
f 1 5 4 3 2
f -5 -4 -3 -2 -1
f 1 2 7 6
f 1 6 10 5
f 2 3 8 7
f 3 4 9 8
f 4 5 10 9
)";

}  // namespace

TEST_CASE("our own hull, moved, turned and in other units, comes back with stem and dimensions") {
  const QuadMesh mesh = bow_mesh(bow());
  QuadMesh moved = mesh;
  // In feet, keel at z = 2 ft, x aft from a point 100 ft ahead of the stem, centre plane at y = 7 ft.
  for (Vec3& p : moved.points)
    p = (Vec3(-p.x(), -p.y(), p.z() + bow().T) / 0.3048 + Vec3(100.0, 7.0, 2.0)).eval();
  MeshFrame frame;
  frame.unit = 0.3048;
  frame.forward = -Vec3::UnitX();
  frame.draft = bow().T;
  for (const char* name : {"hull.obj", "hull.stl", "hull.ply"}) {
    INFO(name);
    const ImportedHull hull = through_file(moved, name, frame);
    CHECK(degrees(largest_difference(hull.measured.angles, bow().angles)) < 0.05);
    constexpr double single = 1e-4;  // of single precision, which STL has
    CHECK(hull.stem == Approx(-30.48).margin(single));
    CHECK(hull.measured.P0.norm() < single);
    CHECK(hull.L == Approx(bow().L).epsilon(single));
    CHECK(hull.B == Approx(bow().B).epsilon(single));
    CHECK(hull.T == Approx(bow().T).epsilon(single));
    CHECK(hull.D == Approx(bow().D).epsilon(single));
    CHECK(hull.Lf <= bow().Lf * 1.001);
    CHECK(hull.Lf > 0.7 * bow().Lf);  // the fairing of the shoulder nears the full beam early
    CHECK(enclosed_volume(hull.mesh) == Approx(enclosed_volume(mesh)).epsilon(single));
    const Hull as = as_hull(hull);
    CHECK(as.status == HullStatus::ok);
    CHECK(std::isnan(as.requested.stem));
    CHECK(as.form == std::string("imported from ") + name);
  }
}

TEST_CASE("a left-handed file is the mirror image") {
  QuadMesh mesh = bow_mesh(bow());
  mesh.points[0].y() += 1e-3;  // a mark on one side
  QuadMesh image = mesh;
  for (Vec3& p : image.points) p.y() = -p.y();
  MeshFrame frame;
  frame.left_handed = true;
  const QuadMesh back = in_hull_frame(image, frame);
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    REQUIRE((back.points[k] - mesh.points[k]).norm() < 1e-12);  // a mirror image of a mirror image: rounding
}

TEST_CASE("polygons and corners counted from the end") {
  const Scratch scratch;
  write_text_file(scratch.file("wedge.obj"), wedge);
  const ImportedHull hull = import_hull(scratch.file("wedge.obj"), {});
  CHECK(hull.repairs.split == 2);
  CHECK(check_mesh(hull.mesh).ok());
  CHECK(hull.L == Approx(20.5));  // the stem passes z = 0 at x = 0.5
  CHECK(hull.stem == Approx(0.5));
  CHECK(hull.B == Approx(4.0));
  CHECK(hull.D == Approx(2.0));
  // The bow's panels are warped, and split along their shorter diagonals: this is the triangle's at the stem.
  CHECK(degrees(hull.measured.angles.waterline) == Approx(degrees(std::atan2(2.0, 6.0))));
  CHECK(degrees(hull.measured.angles.stem) == Approx(degrees(std::atan2(2.0, 1.0))));
}

TEST_CASE("panels are bow, side, bottom, deck or transom by where they lie") {
  const Scratch scratch;
  write_text_file(scratch.file("wedge.obj"), wedge);
  const QuadMesh mesh = import_hull(scratch.file("wedge.obj"), {}).mesh;
  const auto count = [&](Patch patch) { return std::count(mesh.patch.begin(), mesh.patch.end(), patch); };
  CHECK(count(Patch::deck) == 3);  // five corners in three triangles
  CHECK(count(Patch::bottom) == 3);
  CHECK(count(Patch::bow) == 2);
  CHECK(count(Patch::side) == 2);
  CHECK(count(Patch::transom) == 1);
}

TEST_CASE("a file with corners or coordinates that are none is refused") {
  const Scratch scratch;
  const auto ply = [&](const char* point, const char* panel) {
    write_text_file(
        scratch.file("bad.ply"),
        std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                    "property double z\nelement face 4\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0 0\n1 0 0\n0 1 0\n") +
            point + "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n" + panel + "\n");
    MeshRepairs repairs;
    return read_mesh(scratch.file("bad.ply"), repairs);
  };
  CHECK(ply("0 0 1", "3 2 0 3").quads.size() == 4);
  CHECK_THROWS_AS(ply("0 0 1", "3 2 0 9"), InputError);
  CHECK_THROWS_AS(ply("0 0 nan", "3 2 0 3"), InputError);
}

TEST_CASE("files that are no hull are refused in words") {
  const Scratch scratch;
  const auto refusal = [&](std::string obj, const MeshFrame& frame = {}, bool mirror = false) {
    write_text_file(scratch.file("bad.obj"), obj);
    try {
      import_hull(scratch.file("bad.obj"), frame, {mirror, false, {}});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal(wedge) == "");
  CHECK_THAT(refusal(std::string(wedge) + "f -99 1 2\n"),
             Catch::Contains("bad.obj, line 18") && Catch::Contains("-99") && Catch::Contains("-1 to -10"));
  CHECK_THAT(refusal(std::string(wedge) + "f 1 2\n"), Catch::Contains("three points"));
  MeshFrame high;
  high.waterline = 3.0;
  CHECK_THAT(refusal(wedge, high), Catch::Contains("bad.obj") && Catch::Contains("does not cut the hull"));
  CHECK_THAT(refusal(wedge, {}, true), Catch::Contains("both sides already"));
  std::string broad = wedge;  // on port alone
  for (const char* at : {"v -20 2 -1", "v -20 2 1"})
    broad.replace(broad.find(at), std::string(at).size(), std::string(at).replace(6, 1, "3"));
  CHECK_THAT(refusal(broad), Catch::Contains("of the centre plane") && Catch::Contains("mirrored"));
}

TEST_CASE("a box that reaches into another is united with it") {
  const Scratch scratch;
  std::string two = wedge;
  for (const char* v :
       {"-10 -1 0", "-9 -1 0", "-9 1 0", "-10 1 0", "-10 -1 5", "-9 -1 5", "-9 1 5", "-10 1 5"})
    two += std::string("v ") + v + "\n";
  two += "f 14 13 12 11\nf 15 16 17 18\nf 11 12 16 15\nf 12 13 17 16\nf 13 14 18 17\nf 14 11 15 18\n";
  write_text_file(scratch.file("two.obj"), two);
  write_text_file(scratch.file("wedge.obj"), wedge);
  const ImportedHull united = import_hull(scratch.file("two.obj"), {}),
                     alone = import_hull(scratch.file("wedge.obj"), {});
  CHECK(check_mesh(united.mesh).ok());
  // Of the box of 1 x 2 x 5 m 4 m stand out.
  CHECK(enclosed_volume(united.mesh) == Approx(enclosed_volume(alone.mesh) + 8.0));
  CHECK_THAT(in_words(united.repairs), Catch::VectorContains(united.repairs.notes.at(0)));
  CHECK_THAT(united.repairs.notes.at(0), Catch::Contains("united"));
}
