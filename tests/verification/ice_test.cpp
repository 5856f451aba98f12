// The ice against theory, on small pieces: see docs/verification.md.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "ice_block.h"
#include "solver/stability.h"

using namespace icebow;

namespace {

// Steps a free piece and calls `watch(time)` after each step until it returns false.
class Motion {
 public:
  Motion(IceBlock& ice, const Scenario& s, double g) : ice_(ice) {
    dt_ = 0.8 * stable_time_step(ice.sheet.stencil, ice.material, ice.lattice.dx, s.ice.rho, true);
    drift_.dt = dt_;
    drift_.gravity = g;
    drift_.lift = g * s.water.rho / s.ice.rho;
    drift_.inverse_dx = 1.0 / ice.lattice.dx;
  }
  template <class Watch>
  void run(double end, Watch watch) {
    for (double t = dt_; t < end; t += dt_) {
      ice_.sheet.drift(drift_);
      ice_.sheet.dilatation();
      ice_.sheet.force();
      if (!watch(t)) return;
    }
  }

 private:
  IceBlock& ice_;
  DriftSettings drift_{};
  double dt_;
};

// Time of the n-th sign change of a signal.
class Crossings {
 public:
  bool add(double t, double value) {
    if (previous_ * value < 0.0) times_.push_back(t - (t - t_) * value / (value - previous_));
    previous_ = value;
    t_ = t;
    return times_.size() < 3;
  }
  double period() const { return times_.size() < 3 ? 0.0 : times_[2] - times_[0]; }

 private:
  double previous_ = 0.0, t_ = 0.0;
  std::vector<double> times_;
};

double mean_displacement(const IceBlock& ice, int component) {
  double sum = 0.0;
  ice.for_each([&](int, int, int, std::size_t p) { sum += ice.sheet.u[component][p]; });
  return sum / double(ice.lattice.particles());
}

}  // namespace

TEST_CASE("a free bar rings along its length with the period 2 L / sqrt(E/rho)") {
  const int n = 96;
  const Scenario s = block_scenario(n, 7, 3);
  IceBlock ice(s);
  const double L = n * ice.lattice.dx;
  ice.displace([&](const Vec3& x) -> Vec3 { return {1e-5 * std::cos(pi * x.x() / L), 0.0, 0.0}; });
  ice.accelerate();
  Crossings crossings;
  const std::size_t end = ice.sheet.layout.row(3, 1);
  Motion(ice, s, 0.0).run(0.1, [&](double t) { return crossings.add(t, ice.sheet.u[0][end]); });
  const double theory = 2.0 * L / std::sqrt(s.ice.E / s.ice.rho);
  INFO("period " << crossings.period() << " s, theory " << theory << " s");
  CHECK(crossings.period() == Approx(theory).epsilon(0.06));
}

TEST_CASE("a floe at its draught stays; pushed down it heaves with the period 2 pi sqrt(draught/g)") {
  const Scenario s = block_scenario(16, 9, 3);
  const double draught = s.ice.h * s.ice.rho / s.water.rho;
  {
    IceBlock ice(s);
    Motion(ice, s, gravity).run(0.3, [](double) { return true; });
    CHECK(std::abs(mean_displacement(ice, 2)) < 1e-3 * s.ice.h);
  }
  IceBlock ice(s);
  ice.displace([&](const Vec3&) -> Vec3 { return {0.0, 0.0, -0.05 * s.ice.h}; });
  Crossings crossings;
  Motion(ice, s, gravity).run(1.0, [&](double t) { return crossings.add(t, mean_displacement(ice, 2)); });
  const double theory = 2.0 * pi * std::sqrt(draught / gravity);
  INFO("period " << crossings.period() << " s, theory " << theory << " s");
  CHECK(crossings.period() == Approx(theory).epsilon(0.02));
}

TEST_CASE("a floe under water rises") {
  const Scenario s = block_scenario(16, 9, 3);
  IceBlock ice(s);
  ice.displace([&](const Vec3&) -> Vec3 { return {0.0, 0.0, -3.0 * s.ice.h}; });
  const double before = mean_displacement(ice, 2), t_end = 0.05;
  Motion(ice, s, gravity).run(t_end, [](double) { return true; });
  const double theory =
      0.5 * gravity * (s.water.rho / s.ice.rho - 1.0) * t_end * t_end;  // no drag in the model
  CHECK(mean_displacement(ice, 2) - before == Approx(theory).epsilon(0.02));
}
