// The cantilever test of ice, at rest: what flexural strength a critical stretch stands for. See
// docs/verification.md.
#include <algorithm>
#include <catch2/catch.hpp>

#include "solver/tank/tearing.h"
#include "tests/support/bent_ice.h"

using namespace icebow;

namespace {

struct Strength {
  double first_bond, highest;  //!< 6 M / (b h^2) at the root of the cantilever [Pa]
};

// The load is raised until the beam carries a fifth less than it did.
Strength cantilever_strength(int layers, double dx, double K_I) {
  const int free = 6 * layers, ny = 3 * layers, last = clamped + free - 1;
  Scenario s = block_scenario(last + 1, ny, layers, dx);
  s.ice.s0 = 0.0;
  s.ice.K_I = K_I;
  StillIce beam(s);
  beam.hold([](int i, int, int) { return i < clamped; });
  beam.push([&](int i, int, int) { return i == last; }, {0.0, 0.0, 1.0});
  const double h = s.ice.h, arm = (free - 0.5) * dx, per_load = 6.0 * arm / (ny * dx * h * h);
  const auto away_from_tip = [&](int i, int, int, const Offset& o) {
    return std::max(i, i + o.di) < last - 2;
  };
  Strength strength{0.0, 0.0};
  for (double stress = 1.0; stress > 0.8 * strength.highest;) {
    stress = tear(beam, away_from_tip).load * per_load;
    if (strength.first_bond == 0.0) strength.first_bond = stress;
    strength.highest = std::max(strength.highest, stress);
  }
  return strength;
}

}  // namespace

TEST_CASE("a cantilever breaks where its surface reaches the critical stretch, so the finer the stronger") {
  double coarser = 0.0;
  for (int layers : {2, 3}) {
    const double h = 0.039, dx = h / layers, K_I = 60e3;
    const Strength strength = cantilever_strength(layers, dx, K_I);
    Scenario s = block_scenario(40, 9, layers, dx);
    s.ice.s0 = 0.0;
    s.ice.K_I = K_I;
    // The outermost particles are half a spacing within the surface.
    const double s0 = make_material(s.ice, dx, s.numerics.horizon_ratio).s0;
    const double expected = beam_modulus(layers, 3 * layers, true) * s0 * h / (h - dx);
    INFO(layers << " layers, h = 39 mm, K_I = 60 kPa m^0.5: first bond at 6 M / (b h^2) = "
                << strength.first_bond << " Pa, expected of a beam " << expected << " Pa; highest "
                << strength.highest << " Pa");
    CHECK(strength.first_bond == Approx(expected).epsilon(0.25));  // less: the corner of the clamp
    CHECK(strength.first_bond < expected);
    CHECK(strength.highest > strength.first_bond);
    CHECK(strength.highest > 1.1 * coarser);  // no strength of the material: it goes with K_I / sqrt(horizon)
    coarser = strength.highest;
  }
}
