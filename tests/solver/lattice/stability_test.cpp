#include "solver/lattice/stability.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/support/ice_block.h"

using namespace icebow;

namespace {

// Largest speed after many steps of a free sheet that starts with random velocities of 1e-4 m/s.
double speed_after(double dt, int steps) {
  IceBlock b(block_scenario(24, 20, 3));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1e-4f, 1e-4f);
  b.for_each([&](int, int, int, std::size_t p) {
    for (Field& v : b.sheet.v) v[p] = uniform(random);
  });
  DriftSettings drift{};
  drift.dt = dt;
  drift.inverse_dx = 1.0 / b.lattice.dx;
  for (int n = 0; n < steps; ++n) {
    b.sheet.drift(drift);
    b.sheet.dilatation();
    b.sheet.force();
  }
  double fastest = 0.0;
  b.for_each([&](int, int, int, std::size_t p) { fastest = std::max(fastest, b.velocity(p).norm()); });
  return fastest;
}

}  // namespace

TEST_CASE("the computed time step limit is where the scheme becomes unstable") {
  const double dx = 0.013;
  const IceMaterial ice{0.039, 826.6, 52e6, 0.33, 0.0052, 0.0};
  const Material m = make_material(ice, dx, 3.0);
  const double limit = stable_time_step(make_stencil(3, dx, m.delta), m, dx, ice.rho, true);
  // On a sheet of 500 x 250 x 3 by trial.
  CHECK(limit == Approx(6.5e-5).epsilon(0.05));        // 6.5e-5 s holds, 7.0e-5 s does not
  CHECK(speed_after(0.98 * limit, 600) < 1e-3);        // ten times the 1e-4 m/s of its start
  CHECK_FALSE(speed_after(1.03 * limit, 600) < 1e-3);  // grows without end
}

TEST_CASE("the limit scales with the spacing") {
  const IceMaterial ice{0.039, 826.6, 52e6, 0.33, 0.0052, 0.0};
  const Material fine = make_material(ice, 0.01, 3.0), coarse = make_material(ice, 0.02, 3.0);
  const double a = stable_time_step(make_stencil(2, 0.01, fine.delta), fine, 0.01, ice.rho, true);
  const double b = stable_time_step(make_stencil(2, 0.02, coarse.delta), coarse, 0.02, ice.rho, true);
  CHECK(b == Approx(2.0 * a).epsilon(1e-6));  // the same iterations but for rounding
}
