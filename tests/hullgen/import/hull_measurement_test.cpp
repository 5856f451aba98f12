#include "hullgen/import/hull_measurement.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "base/json.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/mesh_io.h"

using namespace icebow;

namespace {

// A directory of its own, gone at the end.
struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "icebow_measure_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return (path / name).string(); }
};

BowParameters preset(BowFamily family, double panels_per_beam) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / panels_per_beam;
  return bow;
}

QuadMesh through_file(const QuadMesh& mesh, const std::string& name) {
  const Scratch scratch;
  write_mesh(scratch.file(name), mesh);
  MeshRepairs repairs;
  return read_mesh(scratch.file(name), repairs);
}

double error_deg(const BowParameters& bow, const QuadMesh& mesh) {
  return degrees(largest_difference(bow.angles, measure_hull(mesh).angles));
}

}  // namespace

TEST_CASE("our own hulls, read back from a file, have the angles asked for") {
  for (const BowFamily family : all_families())
    for (double panels : {60.0, 20.0}) {
      const BowParameters bow = preset(family, panels);
      const QuadMesh mesh = bow_mesh(bow);
      INFO(family_form(family).key << " " << panels);
      CHECK(error_deg(bow, through_file(mesh, "hull.obj")) < 0.05);
      CHECK(error_deg(bow, through_file(mesh, "hull.ply")) < 0.05);
      CHECK(error_deg(bow, through_file(mesh, "hull.stl")) < 0.05);
      CHECK(measure_hull(mesh).beam ==
            Approx(bow_beam(bow)).epsilon(1e-9));  // points of a plane side: rounding
    }
}

// Off the rows of vertices, a cut runs through diagonals, whose middles lie off the surface.
TEST_CASE("between the rows of vertices the angles are those of the surface at that height") {
  for (const BowFamily family : all_families())
    for (double share : {0.31, 0.5, 0.83}) {
      const BowParameters bow = preset(family, 60.0);
      const BowSurface surface = bow_surface(bow);
      const double z = share * panel_size(bow), yq = surface.yq, d = 1e-5;
      QuadMesh mesh = through_file(bow_mesh(bow), "hull.stl");
      for (Vec3& p : mesh.points) p.z() -= z;
      const HullMeasurement found = measure_hull(mesh);
      const auto along_y = [&](double y) {
        return (surface.s(y + d, z) - surface.s(std::max(y - d, 0.0), z)) / (d + std::min(y, d));
      };
      const auto along_z = [&](double y) { return (surface.s(y, z + d) - surface.s(y, z - d)) / (2 * d); };
      INFO(family_form(family).key << " " << share);
      const BowAngles exact = {std::atan2(1.0, -along_z(0.0)), std::atan2(1.0, along_y(0.0)),
                               std::atan2(1.0, -along_z(yq)), std::atan2(-along_z(yq), along_y(yq))};
      const double error = degrees(largest_difference(exact, found.angles));
      CHECK(error < 0.3);  // measured: 0.22 at most, docs/bows.md
    }
}

TEST_CASE("unit, axes and waterline of a file") {
  const BowParameters bow = preset(BowFamily::concave, 20.0);
  QuadMesh mesh = bow_mesh(bow);
  // In millimetres, keel at zero, y up, the bow towards -z and so port towards -x.
  for (Vec3& p : mesh.points) p = 1000.0 * Vec3(-p.y(), p.z() + bow.T, -p.x()).eval();
  MeshFrame frame;
  frame.unit = 0.001;
  frame.forward = -Vec3::UnitZ();
  frame.up = Vec3::UnitY();
  frame.waterline = bow.T;
  const QuadMesh read = in_hull_frame(mesh, frame);
  CHECK(error_deg(bow, read) < 0.05);
  CHECK(enclosed_volume(read) == Approx(enclosed_volume(bow_mesh(bow))));
  CHECK(measure_hull(read).P0.norm() < 1e-9);  // rounding of metres, through a frame
}

TEST_CASE("a hull out of the water, and files that are no meshes") {
  QuadMesh mesh = bow_mesh(preset(BowFamily::concave, 20.0));
  for (Vec3& p : mesh.points) p.z() += 100.0;
  CHECK_THROWS_WITH(measure_hull(mesh), Catch::Contains("does not cut the hull") && Catch::Contains("unit"));

  const Scratch scratch;
  MeshRepairs repairs;
  CHECK_THROWS_WITH(read_mesh(scratch.file("none.stl"), repairs), Catch::Contains("no such file"));
  CHECK_THROWS_WITH(read_mesh(scratch.file("hull.step"), repairs), Catch::Contains(".obj, .stl or .ply"));
  for (const char* name : {"bad.stl", "bad.ply"}) {
    write_text_file(scratch.file(name), "not a mesh\n");
    CHECK_THROWS_AS(read_mesh(scratch.file(name), repairs), InputError);
  }
}
