// Edges made by a cut: their bonds keep the surface correction of whole ice. See docs/verification.md.
#include <catch2/catch.hpp>

#include "held_beam.h"

using namespace icebow;

namespace {

struct Loss {
  double modulus, strength;  // cut beam over own
};

Loss loss_by_cutting(int layers, int columns) {
  const Scenario s = stress_ice(layers);
  const BeamTest own = held_beam(s, columns, Sides::own), cut = held_beam(s, columns, Sides::cut);
  return {cut.elastic_modulus / own.elastic_modulus, cut.flexural_strength / own.flexural_strength};
}

}  // namespace

TEST_CASE("the beam of its own is the virtual test's") {
  const Scenario s = stress_ice(2);
  const BeamTest here = held_beam(s, 4, Sides::own), there = virtual_beam_test(s);
  CHECK(here.elastic_modulus == there.elastic_modulus);
  CHECK(here.flexural_strength == there.flexural_strength);
}

TEST_CASE("a beam cut out of a slab is softer and weaker than one of its own, the more layers the less") {
  // Columns within reach of a cut miss what the correction would give them; with more layers they are a
  // smaller part of 2 h.
  const Loss two = loss_by_cutting(2, 4), three = loss_by_cutting(3, 6);
  INFO("2 h wide, cut over own: 2 layers modulus " << two.modulus << ", strength " << two.strength
                                                   << "; 3 layers " << three.modulus << ", "
                                                   << three.strength);
  // What docs/verification.md says it costs.
  CHECK(two.modulus == Approx(0.77).epsilon(0.03));
  CHECK(two.strength == Approx(0.81).epsilon(0.03));
  CHECK(three.modulus == Approx(0.84).epsilon(0.03));
  CHECK(three.strength == Approx(0.86).epsilon(0.03));
}

TEST_CASE("a cut costs its two sides, whatever lies between them") {
  const Loss narrow = loss_by_cutting(2, 4), wide = loss_by_cutting(2, 8);
  INFO("2 layers, cut over own: modulus " << narrow.modulus << ", strength " << narrow.strength
                                          << " at 2 h wide; " << wide.modulus << ", " << wide.strength
                                          << " at 4 h");
  CHECK((1.0 - wide.modulus) / (1.0 - narrow.modulus) == Approx(0.5).epsilon(0.15));
  CHECK((1.0 - wide.strength) / (1.0 - narrow.strength) == Approx(0.5).epsilon(0.15));
}
