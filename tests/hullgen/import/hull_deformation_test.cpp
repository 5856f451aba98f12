// The bow of an imported hull takes the angles asked for; the rest of the ship keeps its shape.
#include "hullgen/import/hull_deformation.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/mesh/mesh_check.h"
#include "hullgen/mesh/mesh_io.h"

using namespace icebow;

namespace {

ImportedHull imported(BowFamily family) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / 20.0;
  std::string name = (std::filesystem::temp_directory_path() / "icebow_deform_XXXXXX").string();
  const std::filesystem::path directory = mkdtemp(name.data());
  write_mesh((directory / "hull.obj").string(), bow_mesh(bow));
  ImportedHull hull = import_hull((directory / "hull.obj").string(), {});
  std::filesystem::remove_all(directory);
  return hull;
}

BowAngles shifted(BowAngles a, double stem, double waterline, double buttock, double flare) {
  return {a.stem + radians(stem), a.waterline + radians(waterline), a.buttock + radians(buttock),
          a.flare + radians(flare)};
}

}  // namespace

TEST_CASE("the measured angles become the asked ones") {
  for (const BowFamily family :
       {BowFamily::straight_parallel_buttocks, BowFamily::concave, BowFamily::high_flare}) {
    const ImportedHull hull = imported(family);
    const BowAngles own = hull.measured.angles;
    for (const BowAngles& asked :
         {own, shifted(own, 3, 0, 0, 0), shifted(own, 0, 3, 0, 0), shifted(own, 0, 0, -2, 0),
          shifted(own, 0, 0, 0, 3), shifted(own, -2, 3, -2, 2), shifted(own, 4, -2, 3, -3)}) {
      const Hull bow = deformed(hull, asked);
      INFO(family_form(family).key << ": " << bow.reason);
      REQUIRE(bow.status == HullStatus::ok);
      const double error = degrees(largest_difference(bow.measured, asked));
      CHECK(error < 0.001);
      CHECK(check_mesh(bow.mesh).ok());
    }
  }
}

TEST_CASE("asked for the angles it has, the hull stays as it is") {
  const ImportedHull hull = imported(BowFamily::concave);
  const Hull same = deformed(hull, hull.measured.angles);
  REQUIRE(same.status == HullStatus::ok);
  for (std::size_t k = 0; k < hull.mesh.points.size(); ++k)
    REQUIRE((same.mesh.points[k] - hull.mesh.points[k]).norm() <
            1e-9 * hull.L);  // rounding of angles asked as measured
}

TEST_CASE("aft of the box nothing moves, and the step in is smooth") {
  const ImportedHull hull = imported(BowFamily::concave);
  const Hull bow = deformed(hull, shifted(hull.measured.angles, -3, 3, -2, 2));
  REQUIRE(bow.status == HullStatus::ok);
  const double aft = -deformation_reach * hull.Lf, length = bounding_box(hull.mesh).upper.x() - aft;
  double largest = 0.0;
  for (const Vec3& p : hull.mesh.points) largest = std::max(largest, p.x());
  double most = 0.0;
  for (std::size_t k = 0; k < hull.mesh.points.size(); ++k)
    most = std::max(most, std::abs(bow.mesh.points[k].x() - hull.mesh.points[k].x()));
  CHECK(most > 0.2);
  for (std::size_t k = 0; k < hull.mesh.points.size(); ++k) {
    const Vec3 &before = hull.mesh.points[k], &after = bow.mesh.points[k];
    REQUIRE(after.y() == before.y());
    REQUIRE(after.z() == before.z());
    if (before.x() <= aft) REQUIRE(after.x() == before.x());
    // dx grows as the square of the distance from the box's end: B_2^3 + B_3^3 <= 3 s^2.
    const double s = std::max(0.0, (before.x() - aft) / length);
    REQUIRE(std::abs(after.x() - before.x()) <= 3.0 * s * s * 4.0 * most + 1e-12);
  }
}

TEST_CASE("the deformed hull is symmetric, with beam, draught and stem where they were") {
  const ImportedHull hull = imported(BowFamily::straight_parallel_buttocks);
  const Hull bow = deformed(hull, shifted(hull.measured.angles, 3, 2, 2, 2));
  REQUIRE(bow.status == HullStatus::ok);
  CHECK_FALSE(place_without_mirror_image(bow.mesh, 1e-9).has_value());
  const Hydrostatics before = hydrostatics(hull.mesh, {}, 1025.0), after = hydrostatics(bow.mesh, {}, 1025.0);
  CHECK(after.beam == Approx(before.beam));
  CHECK(after.draft == Approx(before.draft));
  CHECK(after.aft_end == Approx(before.aft_end));
  CHECK(after.fore_end == Approx(0.0).margin(1e-9));  // the end stays: rounding of metres
}

TEST_CASE("angles that would fold the hull, or are none, are refused with those it has") {
  const ImportedHull hull = imported(BowFamily::concave);
  for (const BowAngles& asked :
       {shifted(hull.measured.angles, -hull.measured.angles.stem / radians(1.0) + 2.0, 0, 0, 0),
        shifted(hull.measured.angles, 120, 0, 0, 0)}) {
    const Hull bow = deformed(hull, asked);
    CHECK(bow.status == HullStatus::infeasible);
    CHECK(bow.mesh.quads.empty());
    CHECK_THAT(bow.reason, Catch::Contains("cannot be deformed") && Catch::Contains("those it has, stem"));
  }
}
