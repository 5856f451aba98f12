#include "cycle/submersion.h"

#include <catch2/catch.hpp>

#include "base/units.h"
#include "tests/cycle/panels.h"

using namespace icebow;
using namespace icebow::cycle;

namespace {

constexpr double beam = 20.0, draught = 6.0, length = 100.0;

double lift(const Ice& ice) {
  return (ice.rho_w - ice.rho) * 9.81 * ice.h;
}

}  // namespace

TEST_CASE("Submersion: a ramp takes all ice under the bottom") {
  const Ice ice = published_ice();
  const double slope = radians(25.0);
  const Submersion s = submersion(plate(beam, slope, draught), ice, 0.0, length);
  CHECK(s.mean_depth == Approx(draught));
  CHECK(s.under_bottom == 1.0);
  CHECK(s.potential == Approx(lift(ice) * beam * draught));
  // cos(slope) along the ramp, whose length is draught / sin(slope), and the bottom up to 0.7 of the length
  const double along = draught / std::tan(slope);
  CHECK(s.friction == Approx(0.1 * lift(ice) * beam * (along + 0.7 * length - along))
                          .epsilon(0.03));  // one row of 80 at either end of the ramp
  CHECK(s.drag == 0.0);
}

TEST_CASE("Submersion: the water's drag on a ramp") {
  const double slope = radians(40.0), V = 2.0;
  const Ice ice = published_ice();
  const Submersion s = submersion(plate(beam, slope, draught), ice, V, length);
  const double nx = std::sin(slope), along = std::cos(slope), way = draught / std::sin(slope);
  CHECK(s.drag ==
        Approx(0.5 * 1000.0 * 1.2 * V * V * nx * nx * nx / along * way * beam).epsilon(0.03));  // as above
}

TEST_CASE("Submersion: upright sides push ice aside, not down") {
  const Submersion s =
      submersion(sharp_stem(10.0, radians(89.9), radians(20.0), draught), published_ice(), 0.0, length);
  CHECK(s.mean_depth < 0.2);
  CHECK(s.under_bottom == 0.0);
  CHECK(s.friction < 0.02 * lift(published_ice()) * beam * draught);
}

TEST_CASE("Submersion: a wall pushes all down; no hull, no load") {
  CHECK(submersion(plate(beam, pi / 2, draught), published_ice(), 1.0, length).mean_depth == Approx(draught));
  CHECK(submersion(QuadMesh(), published_ice(), 1.0, length).total() == 0.0);
}

TEST_CASE("Submersion: flare decides between bottom and sides") {
  double before = 2.0 * draught;
  for (double stem : {20.0, 30.0, 45.0, 60.0}) {
    const Submersion s =
        submersion(sharp_stem(10.0, radians(stem), radians(30.0), draught), published_ice(), 0.0, length);
    CHECK(s.mean_depth < before);
    before = s.mean_depth;
  }
}
