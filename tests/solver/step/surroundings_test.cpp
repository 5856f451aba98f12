// Forces on the ice besides its bonds and the hull: water, other ice, damped edges.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "base/units.h"
#include "solver/ice/ice_block.h"
#include "solver/run/simulation.h"
#include "solver/step/surrounding_forces.h"
#include "tests/support/main.h"
#include "tests/support/same_process.h"
#include "tests/support/same_record.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

// A free floe of ten by ten columns, two layers thick.
Scenario floe_scenario() {
  Scenario s = tiny_run(0.2, 0.0);
  s.sheet = {0.2, 0.2, FixedEdges::none};
  return s;
}

// Ice without a ship that moves under its surroundings.
class Afloat {
 public:
  Afloat(const Scenario& s, double dt, const Communicator& comm = Communicator::serial())
      : ice(s, comm),
        forces(comm, s, ice.lattice, ice.material, EnergyModel(s, ice.lattice, ice.material, dt)),
        model(s, ice.lattice, ice.material, dt) {
    drift_.dt = dt;
    drift_.gravity = model.gravity;
    drift_.lift = model.lift;
    drift_.inverse_dx = model.inverse_dx;
  }
  void push(const Vec3& velocity) {
    ice.for_each([&](int, int, int, std::size_t p) {
      for (int c = 0; c < 3; ++c) ice.sheet.v[c][p] = velocity[c];
    });
  }
  void accelerate() {
    ice.accelerate();
    forces.apply(ice.sheet, steps, {});
  }
  void step() {
    ++steps;
    ice.sheet.drift(drift_);
    accelerate();
  }
  double mean(const Field* field, int c) const {
    double sum = 0.0;
    ice.for_each([&](int, int, int, std::size_t p) { sum += field[c][p]; });
    return sum / double(ice.lattice.particles());
  }

  IceBlock ice;
  SurroundingForces forces;
  EnergyModel model;
  std::int64_t steps = 0;

 private:
  DriftSettings drift_{};
};

constexpr double step_s = 5e-5;

}  // namespace

namespace {

// Time from the sheet's level back to it, of a floe that has been pushed up.
double half_period(const Scenario& s, double expected) {
  Afloat floe(s, step_s);
  floe.push({0, 0, 0.002});
  floe.accelerate();
  double before = 0.0;
  while (floe.steps * step_s < 3.0 * expected) {
    floe.step();
    const double z = floe.mean(floe.ice.sheet.u, 2);
    if (floe.steps > 10 && before > 0.0 && z <= 0.0) return floe.steps * step_s;
    before = z;
  }
  return 0.0;
}

// Of (M + m) z'' = -rho_w g A z, for an area's added mass.
double half_period_of(const Scenario& s, double added_mass) {
  return M_PI * std::sqrt((s.ice.rho * s.ice.h + added_mass) / (s.water.rho * gravity));
}

}  // namespace

TEST_CASE("a floe with added mass heaves in its period") {
  if (test_world().size() > 1) return;
  Scenario s = floe_scenario();
  for (const double depth : {0.0, 0.05, 0.2}) {
    s.water.added_mass = depth;
    const double expected = half_period_of(s, s.water.rho * depth);
    CHECK(half_period(s, expected) == Approx(expected).epsilon(0.01));  // found to a step
  }
}

// The mean over a square of the potential of its own uniform sources: 4 (ln(1 + sqrt 2) + (1 - sqrt 2)/3) of
// its side, over 2 pi.
TEST_CASE("a floe in a lid heaves in the period of a square piston") {
  if (test_world().size() > 1) return;
  Scenario s = floe_scenario();
  s.water.inertia = WaterInertia::plane;
  const double root = std::sqrt(2.0), side = 0.2;
  const double mean = 4.0 * (std::log(1.0 + root) + (1.0 - root) / 3.0) * side / (2.0 * M_PI);
  const double expected = half_period_of(s, s.water.rho * mean);
  CHECK(half_period(s, expected) == Approx(expected).epsilon(0.01));  // 5 x 5 cells for the square
  // One that has been taken out of the plane has its layer's.
  s.water.added_mass = 0.05;
  Afloat below(s, step_s);
  below.ice.displace([](const Vec3&) { return Vec3(0, 0, -0.5); });
  below.accelerate();
  const double M = s.ice.rho * s.ice.h, lift = (s.water.rho - s.ice.rho) * gravity * s.ice.h;
  const double a = below.mean(below.ice.sheet.acceleration, 2) + lift / M;
  CHECK(a == Approx(lift / (M + s.water.rho * 0.05)).epsilon(1e-3));  // single precision
}

// Lift goes by each particle's height as if its cube were upright: a floe's is right however it lies.
TEST_CASE("the lift of a tilted floe that is partly submerged is that of the water it displaces") {
  if (test_world().size() > 1) return;
  Scenario s = floe_scenario();
  s.ice.h = 0.06;
  const IceBlock floe(s);
  const EnergyModel model(s, floe.lattice, floe.material, step_s);
  const double dx = s.numerics.dx, cube = dx * dx * dx;
  double worst = 0.0;
  for (const double tilt : {0.0, 0.2, 0.45, 0.8, 1.2, M_PI / 2}) {
    for (double depth = -0.1; depth <= 0.1; depth += 0.013) {
      const auto height = [&](double x, double z) {
        return std::sin(tilt) * (x - 0.1) + std::cos(tilt) * z - depth;
      };
      double lift = 0.0, exact = 0.0;
      floe.for_each([&](int i, int, int k, std::size_t) {
        const double x = floe.lattice.x(i), z = floe.lattice.z(k);
        lift += cube * (model.weight_and_lift(height(x, z)) + model.gravity) / model.lift;
        constexpr int cuts = 20;
        for (int a = 0; a < cuts; ++a) {
          for (int c = 0; c < cuts; ++c) {
            const double part = height(x + dx * ((a + 0.5) / cuts - 0.5), z + dx * ((c + 0.5) / cuts - 0.5));
            if (part < 0.0) exact += cube / (cuts * cuts);
          }
        }
      });
      worst = std::max(worst, std::abs(lift - exact) / (cube * double(floe.lattice.particles())));
    }
  }
  INFO("largest error over the floe's volume: " << worst);
  CHECK(worst < 0.01);
}

// Weight, lift and drag in balance: v = sqrt(2 (rho_w - rho) g h / (rho_w C)).
TEST_CASE("a floe let go under water rises at the speed that its drag allows") {
  if (test_world().size() > 1) return;
  Scenario s = floe_scenario();
  s.water.drag = 1.2;
  Afloat floe(s, step_s);
  floe.ice.displace([](const Vec3&) { return Vec3(0, 0, -1.0); });
  floe.accelerate();
  while (floe.mean(floe.ice.sheet.u, 2) < -0.2) floe.step();
  const double v = std::sqrt(2.0 * (s.water.rho - s.ice.rho) * gravity * s.ice.h / (s.water.rho * 1.2));
  CHECK(floe.mean(floe.ice.sheet.v, 2) == Approx(v).epsilon(0.01));  // approached, not reached
}

TEST_CASE("water goes with ice across its plane, whichever way that has turned, and not along it") {
  if (test_world().size() > 1) return;
  Scenario s = floe_scenario();
  s.water.added_mass = 0.1;
  s.water.buoyancy_and_gravity = false;
  Afloat floe(s, step_s);
  // On edge, deep under water: the plate's normal is the course.
  const double deep = -2.0;
  floe.ice.displace([&](const Vec3& x) { return Vec3(x.z() - x.x(), 0.0, -x.x() + deep - x.z()); });
  floe.ice.accelerate();
  const Vec3 pull(3.0, 2.0, 1.0);
  floe.ice.for_each([&](int, int, int, std::size_t p) {
    for (int c = 0; c < 3; ++c) floe.ice.sheet.acceleration[c][p] = pull[c];
  });
  floe.forces.apply(floe.ice.sheet, 1, {});
  constexpr double single = 1e-4;  // accelerations in single precision
  const double M = s.ice.rho * s.ice.h, with = M / (M + s.water.rho * s.water.added_mass);
  CHECK(floe.mean(floe.ice.sheet.acceleration, 0) == Approx(with * pull.x()).epsilon(single));
  CHECK(floe.mean(floe.ice.sheet.acceleration, 1) == Approx(pull.y()).epsilon(single));
  CHECK(floe.mean(floe.ice.sheet.acceleration, 2) == Approx(pull.z()).epsilon(single));
}

namespace {

// Two halves of a block, with no bond between the first 16 columns and the rest.
Scenario two_floes() {
  Scenario s = floe_scenario();
  s.sheet.length = 0.64;
  s.water.buoyancy_and_gravity = false;
  s.numerics.floe_contact = true;
  s.ice.crushing_pressure = 120e3;
  return s;
}

void cut_apart(IceSheet& sheet) {
  for (int jl = -reach; jl < sheet.layout.columns; ++jl) {
    for (int k = 0; k < sheet.layout.nz; ++k) {
      for (int b = 0; b < sheet.layout.blocks; ++b) {
        for (int n = 0; n < sheet.stencil.slots(k); ++n) {
          const Offset& o = sheet.stencil.half[k][n];
          for (int l = 0; l < block; ++l) {
            const int i = b * block + l;
            if ((i < block) != (i + o.di < block))
              (sheet.bits.row(jl, k) + std::ptrdiff_t(b) * sheet.bits.per_block())[n] &=
                  std::uint16_t(~(1u << l));
          }
        }
      }
    }
  }
  sheet.find_cracks();
}

}  // namespace

// That run into each other at 0.2 m/s.
TEST_CASE("floes that meet stop each other and give nothing away but their motion") {
  if (test_world().size() > 1) return;
  const Scenario s = two_floes();
  Afloat floes(s, step_s);
  const double gap = 0.004, speed = 0.1;
  cut_apart(floes.ice.sheet);
  floes.ice.for_each([&](int i, int, int, std::size_t p) {
    floes.ice.sheet.u[0][p] = i < block ? 0.0 : gap;
    floes.ice.sheet.v[0][p] = i < block ? speed : -speed;
  });
  floes.accelerate();
  const double mass = s.ice.rho * std::pow(s.numerics.dx, 3);
  const auto momentum_and_energy = [&] {
    std::pair<double, double> sum{0.0, 0.0};
    floes.ice.for_each([&](int, int, int, std::size_t p) {
      sum.first += mass * floes.ice.sheet.v[0][p];
      sum.second += 0.5 * mass * floes.ice.velocity(p).squaredNorm();
    });
    return sum;
  };
  const auto [p0, e0] = momentum_and_energy();
  double nearest = 1.0;
  while (floes.steps * step_s < 0.1) {
    floes.step();
    double left = -1.0, right = 1.0;
    floes.ice.for_each([&](int i, int, int, std::size_t p) {
      const double x = floes.ice.lattice.x(i) + floes.ice.sheet.u[0][p];
      if (i < block) left = std::max(left, x);
      if (i >= block) right = std::min(right, x);
    });
    nearest = std::min(nearest, right - left);
  }
  const auto [p1, e1] = momentum_and_energy();
  const double all = mass * speed * double(floes.ice.lattice.particles());
  CHECK(p1 == Approx(p0).margin(1e-6 * all));  // single precision, at each particle
  CHECK(nearest > 0.9 * s.numerics.dx);        // they met and did not pass through each other
  CHECK(nearest < s.numerics.dx);
  CHECK(e1 < 0.3 * e0);
  // What the contact took is what they lost, but for what still rings in their bonds.
  const double taken = double(floes.forces.counts().floes) * floes.model.quantum;
  CHECK(taken == Approx(e0 - e1).epsilon(0.15));  // bonds ring
}

// Two floes that overlap by a tenth of a spacing, the facing column of one just moved by the hull.
TEST_CASE("moving ice against other ice is the hull's work, and taken from the ice") {
  if (test_world().size() > 1) return;
  const Scenario s = two_floes();
  Afloat floes(s, step_s);
  IceSheet& sheet = floes.ice.sheet;
  cut_apart(sheet);
  const Vec3 push(1e-4, 2e-4, 0.0);
  std::vector<HullStrike> strikes;
  floes.ice.for_each([&](int i, int, int, std::size_t p) {
    sheet.u[0][p] = i < block ? 0.0 : -0.1 * s.numerics.dx;
    if (i == block - 1) strikes.push_back({p, Vec3::Zero(), push});
  });
  std::sort(strikes.begin(), strikes.end(), [](const auto& a, const auto& b) { return a.p < b.p; });
  const auto taken = [&](const std::vector<HullStrike>& by_hull) {
    floes.ice.accelerate();
    const std::int64_t before = floes.forces.counts().floes, work = floes.forces.apply(sheet, 0, by_hull);
    return std::pair(double(floes.forces.counts().floes - before), double(work));
  };
  const auto [unmoved, nothing] = taken({});
  const auto [moved, work] = taken(strikes);
  const double force = 0.01 * s.ice.E * s.numerics.dx * 0.1 * s.numerics.dx;
  CHECK(nothing == 0.0);
  CHECK(work * floes.model.quantum ==
        Approx(double(strikes.size()) * force * push.x()).epsilon(1e-4));  // single precision
  CHECK(moved - unmoved == work);
}

namespace {

// What other ice does to two floes of which one slides along the other's face at this speed, pressed by an
// overlap of a fiftieth of a spacing.
struct Sliding {
  Vec3 left = Vec3::Zero(), right = Vec3::Zero();  //!< forces [N]
  double taken = 0.0;                              //!< in a step [J]
};

Sliding slide(double friction, double speed) {
  Scenario s = two_floes();
  s.numerics.floe_friction = friction;
  Afloat floes(s, step_s);
  IceSheet& sheet = floes.ice.sheet;
  cut_apart(sheet);
  floes.ice.for_each([&](int i, int, int, std::size_t p) {
    sheet.u[0][p] = i < block ? 0.0 : -0.02 * s.numerics.dx;
    sheet.v[1][p] = i < block ? 0.0 : speed;
  });
  floes.ice.accelerate();
  std::vector<Vec3> bonds(sheet.layout.size, Vec3::Zero());
  floes.ice.for_each([&](int, int, int, std::size_t p) { bonds[p] = floes.ice.acceleration(p); });
  floes.forces.apply(sheet, 0, {});
  const double mass = s.ice.rho * std::pow(s.numerics.dx, 3);
  Sliding found;
  found.taken = double(floes.forces.counts().floes) * floes.model.quantum;
  floes.ice.for_each([&](int i, int, int, std::size_t p) {
    (i < block ? found.left : found.right) += mass * (floes.ice.acceleration(p) - bonds[p]);
  });
  return found;
}

}  // namespace

TEST_CASE(
    "pieces that slide along each other are held by Coulomb's friction, and creep where they are slow") {
  if (test_world().size() > 1) return;
  const Sliding fast = slide(0.3, 0.2), smooth = slide(0.0, 0.2);
  CHECK(std::abs(smooth.left.y()) < 1e-6 * std::abs(smooth.left.x()));     // single precision
  CHECK(fast.left.x() == Approx(smooth.left.x()).epsilon(1e-4));           // single precision
  CHECK(fast.left.y() == Approx(-0.3 * fast.left.x()).epsilon(1e-3));      // dragged along
  CHECK((fast.left + fast.right).norm() < 1e-6 * fast.left.norm());        // single precision
  CHECK(slide(0.3, 0.4).left.y() == Approx(fast.left.y()).epsilon(1e-3));  // likewise
  // Friction takes its force times the way; within the step it slows what it holds by some per cent.
  CHECK(fast.taken - smooth.taken ==
        Approx(fast.left.y() * 0.2 * step_s).epsilon(0.1));  // slowed within the step
  // So slow that they creep: in proportion to the speed.
  const double creep = slide(0.3, 1e-3).left.y();
  CHECK(creep > 0.0);
  CHECK(creep < 0.1 * fast.left.y());
  CHECK(slide(0.3, 2e-3).left.y() == Approx(2.0 * creep).epsilon(1e-4));  // single precision
}

namespace {

// Weak ice that breaks into floes in water, in a window that moves.
Scenario everything() {
  Scenario s = tiny_run(1.28, 0.42);
  s.sheet.window_ahead = 0.9;  // moves at 0.38 m
  s.sheet.width = 0.4;
  s.V = 1.0;
  s.ice.K_I = 0.0;
  s.ice.tensile_strength = 60e3;
  s.ice.crushing_pressure = 200e3;
  s.numerics.contact = ContactRule::crushing;
  s.water.inertia = WaterInertia::plane;
  s.water.added_mass = 0.1;
  s.water.drag = 1.2;
  s.sheet.absorbing = 0.15;
  s.numerics.floe_contact = true;
  s.numerics.floe_friction = 0.3;
  return s;
}

void check_same(const RunResult& many, const RunResult& one) {
  REQUIRE(many.status == RunStatus::ok);
  check_same_record(many.history, one.history);
  CHECK(same_process(many.process, one.process));
}

}  // namespace

TEST_CASE("water, ice against ice and damped edges: the same record on any number of ranks, either way") {
  for (const bool half : {false, true}) {
    Scenario s = everything();
    s.sheet.half_model = half;
    const RunResult one = simulate(Communicator::serial(), tiny_hull(), s, {});
    REQUIRE(one.status == RunStatus::ok);
    CHECK(one.history.rows.back().floe_loss != 0.0);
    INFO("half model " << half);
    check_same(simulate(test_world(), tiny_hull(), s, {}), one);
    if (test_world().size() % 2 != 0) continue;
    s.numerics.ranks_along_x = 2;
    INFO("two ranks along the course");
    check_same(simulate(test_world(), tiny_hull(), s, {}), one);
  }
}

TEST_CASE("what the surroundings take is in the energy balance") {
  if (test_world().size() > 1) return;
  Scenario s = everything();
  // Of tough ice: the balance of ice that is crushed has an error of its own.
  s.ice = tiny_run(1.0, 0.1).ice;
  s.numerics.contact = ContactRule::relocation;
  const RunResult r = simulate(Communicator::serial(), tiny_hull(), s, {});
  const HistoryRow& last = r.history.rows.back();
  CHECK(last.water_loss > 0.01 * last.hull_work);
  double error = 0.0;
  for (const HistoryRow& row : r.history.rows)
    if (!std::isnan(row.balance_error)) error = std::max(error, std::abs(row.balance_error));
  CHECK(error < 0.05 * last.hull_work);
}

// A sheet struck at its middle: what comes back to the middle once the waves have been to the edges.
TEST_CASE("damped edges swallow the waves that reach them") {
  if (test_world().size() > 1) return;
  const auto returned = [](double absorbing) {
    Scenario s = floe_scenario();
    s.sheet = {0.2, 3.2, FixedEdges::sides};
    s.sheet.absorbing = absorbing;
    s.ice.E = 5e6;  // characteristic length 0.24 m
    Afloat sheet(s, 1e-4);
    sheet.ice.for_each([&](int, int j, int, std::size_t p) {
      const double y = sheet.ice.lattice.y(j);
      sheet.ice.sheet.v[2][p] = 0.01 * std::exp(-y * y / 0.03);
    });
    sheet.accelerate();
    double energy = 0.0, all = 0.0;
    while (sheet.steps * 1e-4 < 1.2) {
      sheet.step();
      if (sheet.steps == 1 || sheet.steps * 1e-4 > 0.9) {
        double now = 0.0;
        sheet.ice.for_each([&](int, int, int, std::size_t p) { now += sheet.ice.velocity(p).squaredNorm(); });
        (sheet.steps == 1 ? all : energy) = std::max(sheet.steps == 1 ? all : energy, now);
      }
    }
    return energy / all;
  };
  const double closed = returned(0.0), open = returned(0.4);
  CHECK(closed > 0.3);
  CHECK(open < 0.1 * closed);
}
