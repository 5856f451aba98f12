// Free floes in water against Archimedes: see docs/verification.md.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "solver/tank/still_ice.h"
#include "tests/support/ice_block.h"
#include "tests/support/motion.h"

using namespace icebow;

namespace {

// Volume of the box [0, a] where n . x <= c: one pyramid at each corner, all n > 0 (Scardovelli and Zaleski
// 2000).
double cut_box_volume(const Vec3& a, const Vec3& n, double c) {
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double depth = c, sign = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(corner >> axis & 1)) continue;
      depth -= n[axis] * a[axis];
      sign = -sign;
    }
    if (depth > 0.0) sum += sign * depth * depth * depth;
  }
  return sum / (6.0 * n.prod());
}

// A floe turned about its middle, whose middle is at `height` above the water.
struct Turned {
  Vec3 size;
  Eigen::Matrix3d turn;
  double height;
  double volume() const { return size.prod(); }
  double submerged() const {
    const Vec3 up = turn.transpose() * Vec3::UnitZ(), n = up.cwiseAbs();
    return cut_box_volume(size, n, 0.5 * n.dot(size) - height);
  }
};

// Volume of water [m^3] whose weight is the lift that the drift gives a floe put there.
double displaced(const Scenario& s, const Turned& floe) {
  IceBlock ice(in_double_precision(s));
  const Lattice& l = ice.lattice;
  const Vec3 middle(0.5 * (l.x(0) + l.x(l.nx - 1)), 0.0, 0.5 * (l.z(0) + l.z(l.nz - 1)));
  ice.displace(
      [&](const Vec3& x) -> Vec3 { return floe.turn * (x - middle) + Vec3(0.0, 0.0, floe.height) - x; });
  DriftSettings one_second{};
  one_second.dt = 1.0;
  one_second.lift = gravity * s.water.rho / s.ice.rho;  // and no weight
  one_second.inverse_dx = 1.0 / l.dx;
  ice.sheet.drift(one_second);
  double sum = 0.0;
  ice.for_each([&](int, int, int, std::size_t p) { sum += ice.sheet.v[2][p]; });
  return sum / one_second.lift * l.particle_volume();
}

}  // namespace

TEST_CASE("a floe at its draught stays; pushed down it heaves with the period 2 pi sqrt(draught/g)") {
  const Scenario s = block_scenario(16, 9, 3);
  const double draught = s.ice.h * s.ice.rho / s.water.rho;
  {
    IceBlock ice(s);
    Motion(ice, s, gravity).run(0.3, [](double) { return true; });
    CHECK(std::abs(mean_displacement(ice, 2)) < 1e-3 * s.ice.h);  // afloat from the start: single precision
  }
  IceBlock ice(s);
  ice.displace([&](const Vec3&) -> Vec3 { return {0.0, 0.0, -0.05 * s.ice.h}; });
  Crossings crossings;
  Motion(ice, s, gravity).run(1.0, [&](double t) { return crossings.add(t, mean_displacement(ice, 2)); });
  const double theory = 2.0 * pi * std::sqrt(draught / gravity);
  INFO("period " << crossings.period() << " s, theory " << theory << " s");
  CHECK(crossings.period() == Approx(theory).epsilon(1e-4));  // crossings lie between steps
}

TEST_CASE("a floe under water rises") {
  const Scenario s = block_scenario(16, 9, 3);
  IceBlock ice(s);
  ice.displace([&](const Vec3&) -> Vec3 { return {0.0, 0.0, -3.0 * s.ice.h}; });
  const double before = mean_displacement(ice, 2), t_end = 0.05;
  Motion(ice, s, gravity).run(t_end, [](double) { return true; });
  const double theory =
      0.5 * gravity * (s.water.rho / s.ice.rho - 1.0) * t_end * t_end;  // no drag in the model
  const double rise = mean_displacement(ice, 2) - before;
  INFO("rise " << rise << " m, theory " << theory << " m");
  CHECK(rise == Approx(theory).epsilon(2e-3));  // still moving by as much
}

TEST_CASE("a floe that was tilted rolls and pitches with the period of its metacentric height") {
  const Scenario s = block_scenario(24, 12, 3);
  const double h = s.ice.h, draught = h * s.ice.rho / s.water.rho;
  for (int axis : {0, 1}) {  // turns about x: roll; about y: pitch
    IceBlock ice(s);
    const double b = (axis == 0 ? ice.lattice.ny : ice.lattice.nx) * ice.lattice.dx, angle = 0.005;
    const double start = 0.5 * (ice.lattice.x(0) + ice.lattice.x(ice.lattice.nx - 1));
    const Vec3 middle(start, 0.0, 0.5 * h - draught);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis == 0 ? Vec3::UnitX() : Vec3::UnitY()).matrix();
    ice.displace([&](const Vec3& x) -> Vec3 { return turn * (x - middle) + middle - x; });
    ice.accelerate();
    Crossings crossings;
    Motion(ice, s, gravity).run(1.5, [&](double t) {
      double moment = 0.0;  // sum of arm times vertical displacement: the tilt
      ice.for_each([&](int i, int j, int k, std::size_t p) {
        const Vec3 arm = ice.position(i, j, k) - middle;
        moment += (axis == 0 ? arm.y() : arm.x()) * ice.sheet.u[2][p];
      });
      return crossings.add(t, moment);
    });
    // Per unit length: inertia rho h b (b^2 + h^2)/12, righting moment rho_w g (b^3/12 - draught b BG).
    const double inertia = s.ice.rho * h * b * (b * b + h * h) / 12.0;
    const double righting = s.water.rho * gravity * (b * b * b / 12.0 - draught * b * 0.5 * (h - draught));
    const double theory = 2.0 * pi * std::sqrt(inertia / righting);
    INFO((axis == 0 ? "roll" : "pitch")
         << " period " << crossings.period() << " s, theory " << theory << " s");
    CHECK(crossings.period() ==
          Approx(theory).epsilon(0.01));  // lift acts at particles' centres, inertia is that of points
  }
}

TEST_CASE("the lift of a turned, partly submerged floe is the weight of the water it displaces") {
  const Scenario s = block_scenario(33, 20, 3);
  const double dx = s.numerics.dx;
  double largest = 0.0, squares = 0.0;
  int n = 0;
  for (double roll : {0.02, 0.2, 0.7, 1.2, 1.55}) {
    for (double pitch : {0.01, 0.1, 0.5, 1.0}) {
      for (double height : {-0.08, -0.03, -0.01, 0.0, 0.01, 0.05}) {
        const Turned floe{
            {33 * dx, 20 * dx, 3 * dx},
            (Eigen::AngleAxisd(roll, Vec3::UnitX()) * Eigen::AngleAxisd(pitch, Vec3::UnitY())).matrix(),
            height};
        const double error = (displaced(s, floe) - floe.submerged()) / floe.volume();
        largest = std::max(largest, std::abs(error));
        squares += error * error;
        ++n;
      }
    }
  }
  INFO("error of the displaced volume, of the floe's: largest " << largest << ", root of mean square "
                                                                << std::sqrt(squares / n));
  CHECK(largest < 3e-3);  // found 1.4e-3: particles meet the water as upright cubes, however tilted
  CHECK(std::sqrt(squares / n) < 5e-4);  // found 2.0e-4: likewise
}

TEST_CASE("a submerged floe has its weight in water, whatever its tilt") {
  const Scenario s = block_scenario(33, 20, 3);
  const Turned floe{{33 * 0.013, 20 * 0.013, 3 * 0.013},
                    Eigen::AngleAxisd(0.8, Vec3(1.0, 2.0, 0.5).normalized()).matrix(),
                    -1.0};
  constexpr double rounding = 1e-9;  // of a sum over 2000 particles, and of the cut of a box
  CHECK(floe.submerged() == Approx(floe.volume()).epsilon(rounding));
  CHECK(displaced(s, floe) == Approx(floe.volume()).epsilon(rounding));
}
