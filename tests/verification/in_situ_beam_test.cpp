// The in-situ beam against the one that is held at its root. See docs/verification.md.
#include <catch2/catch.hpp>

#include "base/errors.h"
#include "solver/tank/virtual_tests.h"
#include "tests/support/held_beam.h"

using namespace icebow;

namespace {

// So stiff that water, 7 h being a small part of its characteristic length, carries nothing.
Scenario stiff_ice(int layers) {
  Scenario s = stress_ice(layers);
  s.ice.E *= 1e4;
  s.ice.tensile_strength *= 1e4;
  return s;
}

constexpr SheetAround small = {3, 3, 1, SheetEdges::held};

}  // namespace

TEST_CASE("without water an in-situ beam is as strong as one with such sides that is held at its root") {
  for (int layers : {2, 3}) {
    const Scenario s = stiff_ice(layers);
    const BeamTest found = virtual_in_situ_test(s, Push::up, small),
                   held = held_beam(s, 2 * layers, Sides::cut);
    const double strength = found.flexural_strength / held.flexural_strength;
    INFO(layers << " layers, in situ over held at the root: strength " << strength << ", modulus "
                << found.elastic_modulus / held.elastic_modulus);
    CHECK(strength == Approx(1.0).epsilon(0.07));               // the root's corners, blunt by a horizon
    CHECK(found.elastic_modulus < 0.9 * held.elastic_modulus);  // the root gives way
  }
}

TEST_CASE("water carries part of an in-situ beam's load, which 6 F L / (b h^2) takes for its strength") {
  const Scenario stiff = stiff_ice(2), soft = stress_ice(2);
  const double without = virtual_in_situ_test(stiff, Push::up).flexural_strength / 1e4,
               with = virtual_in_situ_test(soft, Push::up).flexural_strength,
               held = held_beam(soft, 4, Sides::own).flexural_strength;
  INFO("2 layers, in situ over held at the root: " << without / held << " without water, " << with / held
                                                   << " with");
  CHECK(with > 1.03 * without);
  CHECK(with < held);
}

TEST_CASE("up and down an in-situ beam is as strong") {
  const Scenario s = stress_ice(2);
  const double up = virtual_in_situ_test(s, Push::up).flexural_strength,
               down = virtual_in_situ_test(s, Push::down).flexural_strength;
  INFO("down over up " << down / up);
  CHECK(down == Approx(up).epsilon(0.001));  // found equal; bonds within 1e-3 break together
}

TEST_CASE("the sheet around an in-situ beam is large enough for its strength") {
  for (const Scenario& s : {stiff_ice(2), stress_ice(2)}) {
    const double found = virtual_in_situ_test(s, Push::up).flexural_strength,
                 larger = virtual_in_situ_test(s, Push::up, {10, 10, 1, SheetEdges::held}).flexural_strength;
    INFO("2 layers, over that in a sheet of 10 h around: " << found / larger);
    CHECK(found == Approx(larger).epsilon(0.03));  // found 0.991 and 0.999: the water's share
  }
}

TEST_CASE("the in-situ modulus lies a little above an endless sheet's, and far below the beam's") {
  const Scenario s = stress_ice(2);
  const double held = in_situ_modulus(s), afloat = in_situ_modulus(s, {20, 20, 20, SheetEdges::floating}),
               rigid = held_beam(s, 4, Sides::cut).elastic_modulus;
  INFO("2 layers, modulus over that of a held root with cut sides: sheet held 20 h away "
       << held / rigid << ", afloat there " << afloat / rigid);
  CHECK(afloat < held);  // an endless sheet lies between
  CHECK(afloat > 0.9 * held);
  CHECK(held < 0.8 * rigid);
}

TEST_CASE("half a beam with a plane of symmetry tears as the whole does") {
  Scenario s = specimen(stress_ice(2), 20, 6, 2);
  double load[2];
  std::int64_t bonds[2];
  for (const bool half : {false, true}) {
    s.sheet.half_model = half;
    StillIce beam(s);
    beam.hold([](int i, int, int) { return i < reach; });
    beam.push([](int i, int, int) { return i == 19; }, {0.0, 0.0, half ? 0.5 : 1.0});
    const auto any = [](int, int, int, const Offset&) { return true; };
    for (int n = 0; n < 3; ++n) load[half] = tear(beam, any).load;
    bonds[half] = beam.ice.sheet.bonds();
  }
  CHECK(load[true] == Approx(load[false]).epsilon(1e-3));  // bonds that break together
  CHECK(bonds[true] == bonds[false]);
}

TEST_CASE("of a single layer there is no in-situ beam and no plate to bend") {
  CHECK_THROWS_AS(virtual_in_situ_test(stress_ice(1), Push::up), InputError);
  CHECK_THROWS_AS(in_situ_modulus(stress_ice(1)), InputError);
  CHECK_THROWS_AS(virtual_plate_test(stress_ice(1)), InputError);
}
