// Whole runs on a sheet of two thousand particles: under mpirun each is compared with the same run on one
// rank.
#include "solver/run/simulation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "tests/support/main.h"
#include "tests/support/same_record.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

Scenario tiny() {
  return tiny_run(1.0, 0.12);
}

}  // namespace

TEST_CASE("the hull breaks the ice and feels it") {
  const RunResult r = simulate(test_world(), tiny_hull(), tiny(), {});
  REQUIRE(r.status == RunStatus::ok);
  CHECK(r.history.rows.size() > 20);
  CHECK(r.metrics.resistance.mean > 1.0);
  CHECK(r.metrics.resistance.max >= r.metrics.resistance.q95);
  CHECK(r.metrics.vertical.mean > 0.0);  // the ice lifts the bow
  CHECK(r.metrics.broken_bonds > 100);
  CHECK(r.metrics.broken_bonds < r.metrics.bonds);
  CHECK(r.history.rows.back().broken_bonds == r.metrics.broken_bonds);
  CHECK(r.history.rows.back().advance == Approx(0.12).epsilon(0.03));  // the last sample, not the last step
}

namespace {

void check_same(const RunResult& many, const RunResult& one) {
  check_same_record(many.history, one.history);
  CHECK(many.metrics.broken_volume == one.metrics.broken_volume);
  CHECK(same_number(many.metrics.mean_damage, one.metrics.mean_damage));
  CHECK(many.metrics.floes == one.metrics.floes);
}

}  // namespace

TEST_CASE(
    "any number of ranks, along or across the course, gives the same record bit for bit and the same "
    "damage") {
  const Scenario s = tiny();
  const RunResult one = simulate(Communicator::serial(), tiny_hull(), s, {});
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
}

TEST_CASE("cracks cross the cut between ranks along the course unchanged") {
  if (test_world().size() % 2 != 0) return;
  Scenario s = tiny();
  s.numerics.ranks_along_x = 2;  // the cut is at x = 0.64 m
  s.advance = 0.5;
  const RunResult many = simulate(test_world(), tiny_hull(), s, {});
  check_same(many, simulate(Communicator::serial(), tiny_hull(), s, {}));
  CHECK(many.metrics.broken_bonds > 1000);
}

namespace {

// Breaks by stress, is crushed by the hull.
Scenario weak_ice(Scenario s) {
  s.ice.K_I = 0.0;
  s.ice.tensile_strength = 60e3;
  s.ice.crushing_pressure = 200e3;
  s.numerics.contact = ContactRule::crushing;
  return s;
}

}  // namespace

TEST_CASE("ice that breaks by stress and is crushed: the same record on any number of ranks, either way") {
  Scenario s = weak_ice(tiny());
  s.advance = 0.3;
  const RunResult one = simulate(Communicator::serial(), tiny_hull(), s, {});
  REQUIRE(one.status == RunStatus::ok);
  CHECK(one.metrics.broken_bonds > 500);
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
  if (test_world().size() % 2 != 0) return;
  s.numerics.ranks_along_x = 2;
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
}

TEST_CASE("without friction the first touch pushes along the normal of the stem plane") {
  Scenario s = tiny();
  s.numerics.friction = 0.0;
  s.advance = 0.06;
  s.steady_from = 0.0;
  const double stem = 0.45;
  const RunResult r = simulate(test_world(), tiny_hull(), s, {});
  double Fx = 0.0, Fz = 0.0;
  for (const HistoryRow& row : r.history.rows) {
    if (row.broken_bonds > 0 && Fx < 0.0) break;
    Fx += row.F[0];
    Fz += row.F[2];
  }
  REQUIRE(Fx < 0.0);
  CHECK(Fz / -Fx == Approx(1.0 / std::tan(stem)).epsilon(1e-6));  // rounding of sums
}

TEST_CASE("a symmetric ship in symmetric ice drifts to neither side at first touch") {
  Scenario s = tiny();
  s.advance = 0.045;
  s.steady_from = 0.0;
  const RunResult r = simulate(test_world(), tiny_hull(), s, {});
  double Fx = 0.0, Fy = 0.0;
  for (const HistoryRow& row : r.history.rows) {
    Fx += std::abs(row.F[0]);
    Fy += row.F[1];
  }
  CHECK(std::abs(Fy) < 0.02 * Fx);
}

TEST_CASE("gravity and buoyancy can be switched off") {
  Scenario s = tiny();
  s.water.buoyancy_and_gravity = false;
  s.advance = 0.05;
  const RunResult dry = simulate(test_world(), tiny_hull(), s, {});
  s.water.buoyancy_and_gravity = true;
  const RunResult wet = simulate(test_world(), tiny_hull(), s, {});
  REQUIRE(dry.status == RunStatus::ok);
  CHECK(dry.metrics.resistance.mean != wet.metrics.resistance.mean);
}

TEST_CASE("the other contact rules run and measure a load of the same order") {
  Scenario s = tiny();
  s.numerics.friction = 0.0;
  const double reference = simulate(test_world(), tiny_hull(), s, {}).metrics.resistance.mean;
  for (ContactRule rule : {ContactRule::penalty, ContactRule::paper}) {
    s.numerics.contact = rule;
    const RunResult r = simulate(test_world(), tiny_hull(), s, {});
    REQUIRE(r.status == RunStatus::ok);
    CHECK(r.metrics.resistance.mean > 0.3 * reference);
    CHECK(r.metrics.resistance.mean < 3.0 * reference);
  }
}

TEST_CASE("a run that has recorded enough ends by itself, at the same step on every rank") {
  Scenario s = tiny();
  s.sheet.length = 2.0;
  s.advance = 1.5;
  s.ice.K_I = 10e3;  // brittle: many small events, a short correlation time
  s.stop_when_ci95_below = 1.0;
  const RunResult r = simulate(test_world(), tiny_hull(), s, {});
  REQUIRE(r.status == RunStatus::ok);
  CHECK(r.ended == RunEnd::interval_narrow_enough);
  CHECK(r.metrics.resistance.ci95 <= r.metrics.resistance.mean);
  CHECK(r.metrics.resistance.effective_samples >= 30.0);
  CHECK(r.history.rows.back().advance < 1.4);
  CHECK(test_world().max(double(r.steps)) == -test_world().max(-double(r.steps)));
}

TEST_CASE("the wall time of a run is told by phase") {
  Scenario s = tiny();
  s.advance = 0.05;
  const RunResult r = simulate(test_world(), tiny_hull(), s, {});
  double sum = 0.0;
  for (const PhaseTime& p : r.profile) {
    CHECK(p.mean <= p.max * (1.0 + 1e-9));
    sum += p.mean;
  }
  CHECK(r.profile.size() >= 7);
  CHECK(sum <= 1.05 * r.wall_seconds + 0.05);
  CHECK(sum >= 0.5 * r.wall_seconds);
}

TEST_CASE("a run can be stopped from outside") {
  RunOptions options;
  options.stop = [] { return true; };
  Scenario s = tiny();
  s.sheet.length = 4.0;
  s.advance = 3.5;
  const RunResult r = simulate(test_world(), tiny_hull(), s, options);
  CHECK(r.status == RunStatus::interrupted);
}

TEST_CASE("what cannot be run is refused in words") {
  Scenario s = tiny();
  s.numerics.dt = 1.0;
  CHECK_THROWS_WITH(simulate(test_world(), tiny_hull(), s, {}), Catch::Contains("stability limit"));
  s = tiny();
  s.sheet.width = 0.1;
  CHECK_THROWS_WITH(simulate(test_world(), tiny_hull(), s, {}), Catch::Contains("too narrow"));
  s = tiny();
  s.advance = 2.0;
  CHECK_THROWS_WITH(simulate(test_world(), tiny_hull(), s, {}), Catch::Contains("no ice ahead"));
  s = tiny();
  s.numerics.dx = 0.2;
  CHECK_THROWS_AS(simulate(test_world(), tiny_hull(), s, {}), InputError);
}

TEST_CASE("a run that never touches the ice has failed, and says how far away it was") {
  const Communicator& world = test_world();
  Scenario s = tiny_run(1.28, 0.2);
  s.advance = 0.01;  // some samples, and less than half a spacing
  s.steady_from = 0.0;
  const RunResult result = simulate(world, tiny_hull(), s, {});
  CHECK(result.status == RunStatus::failed);
  CHECK_THAT(result.reason, Catch::Contains("never touched the ice") &&
                                Catch::Contains("m from the nearest ice") &&
                                Catch::Contains("/operation/advance_m"));
}
