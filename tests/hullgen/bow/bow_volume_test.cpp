// The displaced volume in closed form against meshes, and the dimension that keeps it.
#include "hullgen/bow/bow_volume.h"

#include <catch2/catch.hpp>

#include "base/units.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/family.h"
#include "hullgen/hydro/hydrostatics.h"

using namespace icebow;

namespace {

// From the surface point by point, without reamers [m^3].
double summed(const BowParameters& bow) {
  constexpr int n = 400;
  const BowSurface b = bow_surface(bow);
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double z = -bow.T * (i + 0.5) / n, width = b.half_breadth(z) / n;
    for (int j = 0; j < n; ++j) sum += (bow.L - b.s(b.half_beam() * (j + 0.5) / n, z)) * width;
  }
  return 2.0 * sum * bow.T / n;
}

}  // namespace

TEST_CASE("the closed form's volume is that of the surface and the mesh") {
  for (const BowFamily family : all_families()) {
    INFO(family_form(family).key);
    const BowParameters bow = preset_bow(family);
    const double exact = bow_displacement(bow);
    // The middles of cells miss so much of the bilge and the fairing, which stand vertical.
    if (reamer_step(bow) == 0.0) CHECK(exact == Approx(summed(bow)).epsilon(2e-5));
    // Chords of the bilge's circle, which the mesh joins by length behind the bow, cut off so much.
    CHECK(displaced_volume(bow_mesh(bow), 0.0) == Approx(exact).epsilon(1e-3));
  }
}

TEST_CASE("a length, beam or draught that keeps the displacement") {
  for (const BowFamily family : all_families())
    for (const HeldBy by : {HeldBy::length, HeldBy::beam, HeldBy::draft}) {
      INFO(family_form(family).key << ", " << static_cast<int>(by));
      BowParameters bow = preset_bow(family);
      const double held = bow_displacement(bow);
      bow.angles.stem -= radians(1.0);
      bow.angles.buttock -= radians(1.0);
      const std::optional<double> value = dimension_for_displacement(bow, held, by, 1.0, 500.0);
      REQUIRE(value);
      (by == HeldBy::length ? bow.L : by == HeldBy::beam ? bow.B : bow.T) = *value;
      CHECK(bow_displacement(bow) == Approx(held).epsilon(1e-9));  // rounding
      CHECK_FALSE(dimension_for_displacement(bow, 100.0 * held, by, 1.0, 500.0));
    }
}
