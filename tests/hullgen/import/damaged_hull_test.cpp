// Damaged meshes of our own bows: mended with the right volume and angles, or refused with a reason; never a
// silent wrong value. bench/damaged_meshes runs thousands of them.
#include <algorithm>
#include <catch2/catch.hpp>

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

TEST_CASE("damaged bows are mended right, or refused") {
  int accepted = 0;
  constexpr int meshes = 60;
  for (int seed = 0; seed < meshes; ++seed) {
    BowParameters bow = preset_bow(all_families()[seed % all_families().size()]);
    bow.panel = bow.B / 12.0;
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
      CHECK((!in_words(hull.repairs).empty() || bad.damage == "all triangles"));
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains("damaged: "));
    }
  }
  CHECK(accepted > 0.9 * meshes);
}
