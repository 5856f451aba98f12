// Damaged meshes of our own bows: mended with the right volume and angles, or refused with a reason; never a
// silent wrong value. bench/damaged_meshes runs thousands of them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/import/imported_hull.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/damaged_mesh.h"

using namespace icebow;

namespace {

BowParameters coarse(BowFamily family) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / 12.0;
  return bow;
}

// The first panel of port's waterline aft of the stem gets a point in its upper edge that the panel above it
// does not know of.
QuadMesh with_junction_at_stem(QuadMesh mesh) {
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    for (int c = 0; c < 4; ++c) {
      const auto q = mesh.quads[k];
      const Vec3 a = mesh.points[q[c]], b = mesh.points[q[(c + 1) % 4]];
      const Vec3 &fore = a.y() < b.y() ? a : b, &aft = a.y() < b.y() ? b : a;
      if (mesh.is_triangle(k) || fore.norm() > 1e-9 || std::abs(aft.z()) > 1e-9 || aft.y() < 0.1) continue;
      const int middle = static_cast<int>(mesh.points.size());
      mesh.points.push_back(0.5 * (a + b));
      mesh.quads[k] = {middle, q[(c + 1) % 4], q[(c + 2) % 4], q[(c + 3) % 4]};
      mesh.quads.push_back({q[c], middle, q[(c + 3) % 4], q[(c + 3) % 4]});
      mesh.patch.push_back(mesh.patch[k]);
      return mesh;
    }
  return {};
}

}  // namespace

TEST_CASE("a point put into a panel's edge says nothing of the surface, and no bar of a sharp stem") {
  for (const BowFamily family : all_families()) {
    const BowParameters bow = coarse(family);
    INFO(family_form(family).key);
    const QuadMesh sound = bow_mesh(bow), cut = with_junction_at_stem(sound);
    REQUIRE(!cut.quads.empty());
    for (const QuadMesh& mesh : {sound, cut}) {
      const ImportedHull hull = hull_of_mesh(mesh, "bow");
      CHECK(hull.measured.stem_radius == 0.0);
      constexpr double rows = 0.05;  // deg: parabolas through points 1/12 of the beam apart
      CHECK(degrees(largest_difference(hull.measured.angles, bow.angles)) < rows);
    }
  }
}

TEST_CASE("what coarse panels leave unsaid is in the spread") {
  for (const BowFamily family : all_families())
    for (const double panels : {6.0, 8.0}) {
      BowParameters bow = preset_bow(family);
      bow.panel = bow.B / panels;
      INFO(family_form(family).key << ", " << panels);
      const HullMeasurement found = hull_of_mesh(bow_mesh(bow), "bow").measured;
      const BowAngles& s = found.spread;
      const double spread = std::max({s.stem, s.waterline, s.buttock, s.flare});
      // 0.5 deg beside the spread: the bound of a right value
      CHECK(degrees(largest_difference(found.angles, bow.angles) - spread) < 0.5);
    }
}

TEST_CASE("damaged bows are mended right, or refused") {
  int accepted = 0;
  constexpr int meshes = 60;
  for (int seed = 0; seed < meshes; ++seed) {
    const BowParameters bow = coarse(all_families()[seed % all_families().size()]);
    const QuadMesh sound = bow_mesh(bow);
    const DamagedMesh bad = damaged(sound, static_cast<std::uint64_t>(seed));
    INFO(seed << ": " << family_form(bow.family).key << ": " << bad.damage);
    try {
      const ImportedHull hull = hull_of_mesh(bad.mesh, "damaged");
      ++accepted;
      CHECK(check_mesh(hull.mesh).ok());
      // The bounds of a right value are 0.5 % and 0.5 deg, an angle's spread beside.
      const BowAngles& own = hull.measured.spread;
      const double spread = degrees(std::max({own.stem, own.waterline, own.buttock, own.flare}));
      const bool warned = !hull.repairs.warnings.empty();  // of a wrap, whose edges are rounded
      CHECK(displaced_volume(hull.mesh, 0.0) ==
            Approx(displaced_volume(sound, 0.0)).epsilon(5e-3));  // the bound of a right value
      CHECK((warned || degrees(largest_difference(hull.measured.angles, bow.angles)) < 0.5 + spread));
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains("damaged: "));
    }
  }
  CHECK(accepted >= 0.97 * meshes);
}
