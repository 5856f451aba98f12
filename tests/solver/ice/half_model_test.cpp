// The port half with a symmetry plane is the whole symmetric sheet.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "base/errors.h"
#include "solver/ice/sheet_state.h"
#include "solver/run/simulation.h"
#include "solver/watch/recorder.h"
#include "tests/support/ice_block.h"
#include "tests/support/main.h"
#include "tests/support/same_process.h"
#include "tests/support/same_record.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

Scenario half(Scenario s) {
  s.sheet.half_model = true;
  return s;
}

// A run by hand on its own communicator.
struct Run {
  Run(const Communicator& c, const Scenario& scenario)
      : comm(c),
        s(scenario),
        lattice(make_lattice(s)),
        stepper(comm, hull, s, lattice, run_size(hull, s).dt, first_touch_x(hull, lattice)),
        recorder(comm, stepper, s) {}
  const HistoryRow& next_sample() {
    std::string reason;
    do stepper.step();
    while (stepper.steps() % recorder.steps_per_sample() != 0);
    REQUIRE(recorder.sample(stepper, reason));
    return recorder.history().rows.back();
  }

  const Communicator comm;
  QuadMesh hull = tiny_hull();
  Scenario s;
  Lattice lattice;
  Stepper stepper;
  Recorder recorder;
};

Scenario tiny(double length = 1.0, double advance = 0.12) {
  Scenario s = tiny_run(length, advance);
  s.numerics.precision = Precision::fp64;
  return s;
}

// `rounding`: relative, of sums whose terms are the same but for their order.
void check_alike(const HistoryRow& half, const HistoryRow& whole, double rounding) {
  const auto near = [rounding](double value, double scale) {
    return Approx(value).margin(rounding * scale);  // sums in another order
  };
  const double F = std::abs(whole.F[0]);
  CHECK(half.F[0] == near(whole.F[0], F));
  CHECK(half.F[1] == 0.0);
  CHECK(half.F[2] == near(whole.F[2], F));
  CHECK(half.M[0] == 0.0);
  CHECK(half.M[1] == near(whole.M[1], F));
  CHECK(half.M[2] == 0.0);
  CHECK(half.broken_bonds == whole.broken_bonds);
  CHECK(half.contacts == whole.contacts);
  const double work = whole.hull_work + 0.01;  // of some blocks' quanta before first touch
  CHECK(half.hull_work == near(whole.hull_work, work));
  CHECK(half.contact_loss == near(whole.contact_loss, work));
  CHECK(half.kinetic_energy == near(whole.kinetic_energy, work));
  CHECK(half.potential == near(whole.potential, work));
  CHECK(std::isnan(half.elastic) == std::isnan(whole.elastic));
  if (std::isnan(whole.elastic)) return;
  CHECK(half.elastic == near(whole.elastic, work));
  CHECK(half.fracture == near(whole.fracture, work));
  CHECK(half.balance_error == near(whole.balance_error, work));
}

void check_alike(const SheetState& half, const SheetState& whole) {
  REQUIRE(half.lattice.ny == whole.lattice.ny);
  CHECK(half.damage == whole.damage);
  CHECK(half.piece == whole.piece);
  CHECK(half.floes == whole.floes);
  double furthest = 0.0;
  for (int c = 0; c < 3; ++c)
    for (std::size_t n = 0; n < whole.u[c].size(); ++n)
      furthest = std::max<double>(furthest, std::abs(half.u[c][n] - whole.u[c][n]));
  CHECK(furthest < 1e-9);  // metres: the last bit of a displacement of millimetres in single precision
}

}  // namespace

TEST_CASE("a half block with its plane feels what the whole symmetric block feels, torn bonds included") {
  Scenario s = block_scenario(70, 22, 3);
  s.numerics.precision = Precision::fp64;
  IceBlock whole(s), part(half(s), test_world());
  CHECK(part.lattice.ny == 11);
  CHECK(part.lattice.y(0) == whole.lattice.y(11));
  // Opens at the plane and shears along it; even in y but for its own sign.
  const auto displacement = [](const Vec3& x) -> Vec3 {
    const double open = 3e-4 * std::sin(9.0 * x.x()) * std::tanh(200.0 * x.y());
    return {4e-4 * std::cos(60.0 * x.y()) * std::sin(40.0 * x.x()), open, 2e-4 * std::cos(45.0 * x.y())};
  };
  whole.displace(displacement);
  part.displace(displacement);
  std::int64_t torn = part.accelerate();
  test_world().sum(&torn, 1);
  CHECK(torn == whole.accelerate());
  CHECK(torn > 100);
  std::int64_t bonds = part.sheet.bonds();
  test_world().sum(&bonds, 1);
  CHECK(bonds == whole.sheet.bonds());
  const double scale = whole.largest_acceleration();
  double worst = 0.0;
  part.for_each([&](int i, int j, int k, std::size_t p) {
    const std::size_t q = whole.sheet.layout.row(j + 11, k) + i;
    worst = std::max(worst, (part.acceleration(p) - whole.acceleration(q)).norm());
  });
  CHECK(worst < 1e-13 * scale);  // the same sums in another order: rounding
}

TEST_CASE("a half model's record is the whole sheet's, before and after the ice breaks") {
  if (test_world().size() > 1) return;  // the ranks are compared below
  const Communicator alone = Communicator::serial();
  Run whole(alone, tiny()), part(alone, half(tiny()));
  CHECK(part.lattice.particles() * 2 == whole.lattice.particles());
  // Rounding is a few ulp of a sum a step; breaking amplifies it: found 1e-11.
  for (int n = 0; n < 32; ++n) {
    const HistoryRow& row = part.next_sample();
    check_alike(row, whole.next_sample(), 1e-9);
  }
  CHECK(whole.recorder.history().rows.back().broken_bonds > 3000);
  check_alike(gather_state(alone, part.stepper.sheet()), gather_state(alone, whole.stepper.sheet()));
}

TEST_CASE(
    "a half model's record is the whole sheet's across a move of the window, by the ordinary arithmetic") {
  if (test_world().size() > 1) return;
  const QuadMesh hull = sloping_box(0.1, 0.2, 0.08, 0.15, 1.2);
  Scenario s = tiny(1.6, 0.48);
  s.numerics.linear_below = 0.0;  // blocks beside the plane are never linear: 1e-4 of difference
  s.ice.s0 = 0.049;               // too tough to break much
  s.sheet.window_ahead = 1.15;
  s.V = 1.0;
  const RunResult whole = simulate(Communicator::serial(), hull, s, {});
  const RunResult part = simulate(Communicator::serial(), hull, half(s), {});
  REQUIRE(whole.history.rows.size() > 90);
  REQUIRE(part.history.rows.size() == whole.history.rows.size());
  // In fp64 a calm block's series is good to 1e-9.
  for (std::size_t n = 0; n < whole.history.rows.size(); ++n)
    check_alike(part.history.rows[n], whole.history.rows[n], 1e-8);
  CHECK(whole.history.rows.back().broken_bonds > 0);
  CHECK(part.metrics.bonds == whole.metrics.bonds);
  CHECK(part.metrics.broken_bonds == whole.metrics.broken_bonds);
  CHECK(part.metrics.broken_volume == whole.metrics.broken_volume);
}

namespace {

void check_same(const RunResult& many, const RunResult& one) {
  REQUIRE(many.status == RunStatus::ok);
  check_same_record(many.history, one.history);
  CHECK(many.metrics.bonds == one.metrics.bonds);
  CHECK(same_number(many.metrics.mean_damage, one.metrics.mean_damage));
  CHECK(many.metrics.broken_volume == one.metrics.broken_volume);
  CHECK(many.metrics.floes == one.metrics.floes);
  CHECK(same_process(many.process, one.process));
}

void check_on_any_grid(Scenario s) {
  const RunResult one = simulate(Communicator::serial(), tiny_hull(), s, {});
  REQUIRE(one.status == RunStatus::ok);
  CHECK(one.metrics.broken_bonds > 1000);
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
  if (test_world().size() % 2 != 0) return;
  s.numerics.ranks_along_x = 2;
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
}

}  // namespace

TEST_CASE("a half model gives the same record on any number of ranks and any grid") {
  check_on_any_grid(half(tiny_run(1.28, 0.2)));
}

TEST_CASE("a half model in a moving window gives the same record on any number of ranks and any grid") {
  Scenario s = half(tiny_run(1.28, 0.26));
  s.sheet.window_ahead = 1.1;  // moves at 0.18 m
  s.V = 1.0;
  check_on_any_grid(s);
}

TEST_CASE("bonds across the plane break in pairs of mirror images, in single precision too") {
  if (test_world().size() > 1) return;
  Scenario s = half(tiny_run(1.28, 0.56));
  s.sheet.window_ahead = 1.1;
  const QuadMesh hull = tiny_hull();
  const Lattice lattice = make_lattice(s);
  Stepper stepper(Communicator::serial(), hull, s, lattice, run_size(hull, s).dt,
                  first_touch_x(hull, lattice));
  while (s.V * stepper.time() < 0.4) stepper.step();
  const IceSheet& sheet = stepper.sheet();
  const auto alive = [&](int i, int j, int k, const Offset& o) {
    for (int slot = 0; slot < sheet.stencil.slots(k); ++slot) {
      const Offset& there = sheet.stencil.half[k][slot];
      if (there.di == o.di && there.dj == o.dj && there.dk == o.dk)
        return sheet.bits.row(j, k)[i / block * sheet.bits.per_block() + slot] >> (i % block) & 1;
    }
    return -1;
  };
  int broken = 0, unlike = 0;
  for (int j = -reach; j < 0; ++j) {
    for (int k = 0; k < lattice.nz; ++k) {
      for (const Offset& o : sheet.stencil.half[k]) {
        for (int i = reach; i < lattice.nx - reach && j + o.dj >= 0; ++i) {
          const Offset image{-o.di, o.dj, -o.dk};
          const int here = alive(i, j, k, o);
          broken += here == 0;
          unlike += here != alive(i + o.di, -1 - (j + o.dj), k + o.dk, image);
        }
      }
    }
  }
  CHECK(broken > 20);
  CHECK(unlike == 0);
}

TEST_CASE("the energy balance of a half model closes as that of a whole sheet") {
  if (test_world().size() > 1) return;
  const RunResult r = simulate(Communicator::serial(), tiny_hull(), half(tiny_run(1.28, 0.4)), {});
  double error = 0.0;
  for (const HistoryRow& row : r.history.rows)
    if (!std::isnan(row.balance_error)) error = std::max(error, std::abs(row.balance_error));
  INFO("balance error over the hull's work " << error / r.history.rows.back().hull_work);
  CHECK(error > 0.0);
  CHECK(error < 0.05 * r.history.rows.back().hull_work);  // found: 0.025, of the whole sheet 0.021
}

TEST_CASE("an odd number of columns becomes even by one more") {
  Scenario s = tiny();
  s.sheet.width = 27 * s.numerics.dx;
  CHECK(make_lattice(s).ny == 27);
  CHECK(make_lattice(half(s)).ny == 14);
  CHECK(make_lattice(half(s)).width() == Approx(28 * s.numerics.dx));
}

TEST_CASE("a hull that is not the same on both sides is refused, rounding is not") {
  QuadMesh hull = tiny_hull();
  const Scenario s = half(tiny_run(1.0, 0.002));
  hull.points[5].x() += 0.01;
  CHECK_THROWS_AS(simulate(test_world(), hull, s, {}), InputError);
  CHECK_THROWS_WITH(simulate(test_world(), hull, s, {}),
                    Catch::Contains("mirror image") && Catch::Contains("half_model"));
  CHECK(simulate(test_world(), hull, tiny_run(1.0, 0.002), {}).status == RunStatus::ok);
  hull = tiny_hull();
  hull.points[5].x() += 1e-9;
  CHECK(simulate(test_world(), hull, s, {}).status == RunStatus::ok);
}
