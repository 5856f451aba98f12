#include "solver/lattice/stencil.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace icebow;

TEST_CASE("a particle deep inside has 122 neighbours within three spacings, in opposite pairs") {
  const double dx = 0.013;
  const Stencil stencil = make_stencil(7, dx, 3.0 * dx);
  const auto& middle = stencil.family[3];
  REQUIRE(middle.size() == 122);
  for (const Offset& o : middle) {
    int opposite = 0;
    for (const Offset& p : middle) opposite += p.di == -o.di && p.dj == -o.dj && p.dk == -o.dk;
    CHECK(opposite == 1);
    CHECK(o.length <= 3.0 * dx * (1 + 1e-12));
    CHECK(o.volume_factor > 0.0);
    CHECK(o.volume_factor <= 1.0);
  }
}

TEST_CASE("a column keeps each of its bonds once") {
  const Stencil stencil = make_stencil(3, 0.013, 0.039);
  int directed = 0;
  for (const auto& family : stencil.family) directed += static_cast<int>(family.size());
  CHECK(2 * stencil.column_slots() == directed);
}

TEST_CASE("a bond at the horizon counts half of its neighbour's volume") {
  const double dx = 0.02;
  const Stencil stencil = make_stencil(1, dx, 3.0 * dx);
  for (const Offset& o : stencil.family[0]) {
    if (std::abs(o.di) == 3 && o.dj == 0) CHECK(o.volume_factor == Approx(0.5));
    if (std::abs(o.di) == 2 && o.dj == 0) CHECK(o.volume_factor == 1.0);
  }
}

TEST_CASE("layers of a thin sheet see only what exists above and below") {
  const Stencil stencil = make_stencil(3, 0.013, 0.039);
  for (int k = 0; k < 3; ++k) {
    for (const Offset& o : stencil.family[k]) CHECK((k + o.dk >= 0 && k + o.dk < 3));
  }
  CHECK(stencil.family[0].size() == stencil.family[2].size());
  CHECK(stencil.family[0].size() < stencil.family[1].size());
}

TEST_CASE("the paper's critical stretch follows from its toughness and horizon") {
  const IceMaterial ice{0.04, 826.6, 52e6, 0.33, 0.0, 60e3};
  CHECK(critical_stretch(ice, 3 * 0.013) == Approx(0.005247).epsilon(2e-4));  // given to 4 digits
  CHECK(critical_stretch(ice, 3 * 0.020) == Approx(0.004231).epsilon(2e-4));  // given to 4 digits
}

TEST_CASE("without missing neighbours the surface factors only mend the lattice sum") {
  // 122 points stand for a ball: its sums miss the integrals by 10 % (dilatation) and 16 % (distortion).
  const double dx = 0.013;
  const Stencil stencil = make_stencil(7, dx, 3.0 * dx);
  const Material m = make_material({0.1, 826.6, 52e6, 0.33, 0.005, 0.0}, dx, 3.0);
  const SurfaceFactors bulk = surface_factors({3, 3, 3, 3, 3}, stencil, m, dx);
  for (int c = 0; c < 3; ++c) {
    CHECK(bulk.dilatation[c] == Approx(1.0).margin(0.11));  // the sum for the integral
    CHECK(bulk.distortion[c] == Approx(1.0).margin(0.18));  // likewise
    CHECK(bulk.dilatation[c] == Approx(bulk.dilatation[0]));
  }
}

TEST_CASE("a particle at a free edge is corrected upwards across the edge") {
  const double dx = 0.013;
  const Stencil stencil = make_stencil(7, dx, 3.0 * dx);
  const Material m = make_material({0.1, 826.6, 52e6, 0.33, 0.005, 0.0}, dx, 3.0);
  const SurfaceFactors edge = surface_factors({0, 3, 3, 3, 3}, stencil, m, dx);
  CHECK(edge.dilatation[0] > 1.8);
  CHECK(edge.distortion[0] > 1.8);
}
