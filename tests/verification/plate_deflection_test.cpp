// The modulus from a floating plate's deflection. See docs/verification.md.
#include <catch2/catch.hpp>

#include "solver/tank/virtual_tests.h"
#include "tests/support/bent_ice.h"

using namespace icebow;

TEST_CASE("the modulus from a plate's deflection is that of the clamped plate's rigidity") {
  for (int layers : {2, 3}) {
    const double found = virtual_plate_test(block_scenario(1, 1, layers)) / 52e6,
                 clamped_plate = plate_rigidity(layers, true);
    INFO(layers << " layers: plate afloat " << found << " of E, clamped plate " << clamped_plate);
    CHECK(found == Approx(clamped_plate).epsilon(0.04));  // shear is taken off with the bending's E
  }
}

TEST_CASE("the plate is wide enough, and thin enough for its length") {
  const Scenario s = block_scenario(1, 1, 2);
  const double found = virtual_plate_test(s), wider = virtual_plate_test(s, 4.0, 12.0),
               thinner = virtual_plate_test(s, 8.0, 8.0);
  INFO("2 layers, over a plate of 12 l: " << found / wider << "; over one of l = 8 h: " << found / thinner);
  CHECK(found == Approx(wider).epsilon(0.01));    // found 1.003: shear is taken off with the bending's E
  CHECK(found == Approx(thinner).epsilon(0.02));  // likewise: shear counts less in it
}

TEST_CASE("the plate's modulus is in proportion to E, at any size") {
  Scenario s = block_scenario(1, 1, 2, 0.4);
  s.ice.E = 3e9;
  CHECK(virtual_plate_test(s) / 3e9 == Approx(virtual_plate_test(block_scenario(1, 1, 2)) / 52e6)
                                           .epsilon(1e-4));  // the sheet is settled, not solved exactly
}
