// Ice bent by forces at rest, against the theory of beams and plates: see docs/verification.md.
#include <catch2/catch.hpp>

#include "bent_ice.h"

using namespace icebow;

TEST_CASE("a cantilever's modulus nears E with more layers, faster than in proportion to the spacing") {
  double coarser = 1.0;
  for (int layers = 2; layers <= 5; ++layers) {
    const double ratio = beam_modulus(layers, 4 * layers, true) / 52e6, error = (1.0 - ratio) * layers;
    INFO(layers << " layers, width 4 h: modulus of the bent beam " << ratio << " of E");
    CHECK(ratio < 1.0);
    CHECK(error < coarser);
    coarser = error;
  }
  CHECK(coarser < 0.7);  // a modulus above 0.86 E with 5 layers
}

TEST_CASE("corrected edges stiffen a narrow cantilever") {
  double wider = 0.0;
  for (int width_2h : {8, 4, 3}) {
    const double ratio = beam_modulus(4, 2 * width_2h, true) / 52e6;
    INFO("4 layers, width " << 0.5 * width_2h << " h: modulus of the bent beam " << ratio << " of E");
    CHECK(ratio > wider);
    wider = ratio;
  }
}

TEST_CASE("a clamped plate's rigidity nears E h^3 / (12 (1 - nu^2)) with more layers") {
  double coarser = 1.0;
  for (int layers = 2; layers <= 4; ++layers) {
    const double ratio = plate_rigidity(layers, true), error = (1.0 - ratio) * layers;
    INFO(layers << " layers: rigidity " << ratio << " of theory");
    CHECK(ratio < 1.0);
    CHECK(error < coarser);
    coarser = error;
  }
  CHECK(coarser < 0.7);
}

TEST_CASE("without surface correction a sheet bends far too easily") {
  for (int layers = 2; layers <= 3; ++layers) {
    const double beam = beam_modulus(layers, 4 * layers, false) / 52e6;
    const double plate = plate_rigidity(layers, false);
    INFO(layers << " layers: beam " << beam << ", plate " << plate << " of theory");
    CHECK(beam < 0.6 * beam_modulus(layers, 4 * layers, true) / 52e6);
    CHECK(plate < 0.5);
  }
}
