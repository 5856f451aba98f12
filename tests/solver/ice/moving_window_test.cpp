// A window that moves with the ship instead of a long sheet.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "solver/run/simulation.h"
#include "solver/step/stepper.h"
#include "tests/support/main.h"
#include "tests/support/same_process.h"
#include "tests/support/same_record.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

// Four blocks along the course; the window moves at 0.18 m and at 0.50 m.
Scenario windowed() {
  Scenario s = tiny_run(1.28, 0.56);
  s.sheet.window_ahead = 1.1;
  return s;
}

void check_same(const RunResult& many, const RunResult& one) {
  REQUIRE(many.status == RunStatus::ok);
  check_same_record(many.history, one.history);
  CHECK(same_number(many.metrics.mean_damage, one.metrics.mean_damage));
  CHECK(many.metrics.floes == one.metrics.floes);
  CHECK(same_process(many.process, one.process));
}

double mean_resistance(const RunResult& r, double from, double to) {
  double sum = 0.0;
  int n = 0;
  for (const HistoryRow& row : r.history.rows) {
    if (row.advance <= from || row.advance > to) continue;
    sum -= row.F[0];
    ++n;
  }
  return sum / n;
}

}  // namespace

TEST_CASE("a moving window gives the same record on any number of ranks and any grid") {
  Scenario s = windowed();
  const RunResult one = simulate(Communicator::serial(), tiny_hull(), s, {});
  REQUIRE(one.status == RunStatus::ok);
  check_same(simulate(test_world(), tiny_hull(), s, {}), one);
  if (test_world().size() % 2 == 0) {
    s.numerics.ranks_along_x = 2;
    check_same(simulate(test_world(), tiny_hull(), s, {}), one);
  }
}

TEST_CASE("what a window drops is in the numbers of the broken ice") {
  if (test_world().size() > 1) return;
  const RunResult r = simulate(Communicator::serial(), tiny_hull(), windowed(), {});
  const BreakingProcess& p = r.process;
  CHECK(p.ice.volume > r.metrics.broken_volume);
  CHECK(p.energy.left_astern > 0.0);
}

TEST_CASE("fresh ice is whole, at rest, and bonded to the old") {
  const Scenario s = windowed();
  const Lattice lattice = make_lattice(s);
  IceSheet sheet(s, lattice, make_partition(lattice, 0, 1),
                 make_material(s.ice, lattice.dx, s.numerics.horizon_ratio));
  const std::int64_t whole = sheet.bits.count();
  // A bending sheet's free edge moves by millimetres: what is laid at rest beside it would be torn off.
  CHECK(sheet.held(lattice.nx - 1, lattice.ny / 2));
  // Marks one particle, and breaks all bonds of a row's first two blocks.
  const std::size_t row = sheet.layout.row(5, 1);
  sheet.u[2][row + 20] = 0.25;
  for (int w = 0; w < 2 * sheet.bits.per_block(); ++w) sheet.bits.row(5, 0)[w] = 0;
  const std::int64_t broken = whole - sheet.bits.count();
  sheet.drop_first_block(Communicator::serial());
  CHECK(sheet.u[2][row + 4] == Approx(0.25));
  CHECK(sheet.u[2][row + 20] == 0.0);
  CHECK(sheet.lattice.x(0) == Approx(lattice.x(16)));
  // Half of the broken ones left astern; what is laid makes up for what is dropped.
  CHECK(whole - sheet.bits.count() < broken);
  CHECK(whole - sheet.bits.count() > broken / 3);
  sheet.drop_first_block(Communicator::serial());
  CHECK(sheet.bits.count() == whole);
}

// Ahead of the stem the response decays as exp(-x / (sqrt(2) l)) with the characteristic length l; astern the
// window holds the whole front of the hull.
TEST_CASE("the window's load is that of a long sheet") {
  if (test_world().size() > 1) return;  // nothing to do with ranks, and long
  Scenario s = windowed();
  s.sheet.length = 1.6;  // moves at 0.5 m and at 0.82 m
  s.advance = 0.9;
  const RunResult window = simulate(Communicator::serial(), tiny_hull(), s, {});
  s.sheet = {2.56, 0.56, FixedEdges::sides};
  const RunResult sheet = simulate(Communicator::serial(), tiny_hull(), s, {});
  REQUIRE(window.status == RunStatus::ok);
  REQUIRE(sheet.status == RunStatus::ok);
  const double decay = std::exp(-1.1 / (std::sqrt(2.0) * 0.42));  // from the far end to the stem
  const double before = mean_resistance(sheet, 0.0, 0.5), after = mean_resistance(sheet, 0.5, 0.9);
  CHECK(mean_resistance(window, 0.0, 0.5) == Approx(before).epsilon(decay));
  CHECK(mean_resistance(window, 0.5, 0.9) == Approx(after).epsilon(decay));
}

TEST_CASE("the energy balance holds across moves of the window") {
  if (test_world().size() > 1) return;
  const RunResult r = simulate(Communicator::serial(), tiny_hull(), windowed(), {});
  double error = 0.0;
  for (const HistoryRow& row : r.history.rows)
    if (!std::isnan(row.balance_error)) error = std::max(error, std::abs(row.balance_error));
  CHECK(error > 0.0);
  CHECK(error < 0.05 * r.history.rows.back().hull_work);
}

namespace {

// Before and after the first move of a window, at 0.46 m of advance.
struct Move {
  double energy_before = 0.0, energy_after = 0.0;  //!< kinetic [J]
  std::int64_t bonds_before = 0, bonds_after = 0;  // broken so far
};

Move first_move(double ahead) {
  Scenario s = tiny_run(0.46 + ahead, 0.6);
  s.sheet.window_ahead = ahead;
  s.numerics.friction = 0.0;
  const RunResult r = simulate(Communicator::serial(), tiny_hull(), s, {});
  REQUIRE(r.status == RunStatus::ok);
  Move move;
  for (const HistoryRow& row : r.history.rows) {
    if (row.advance > 0.40 && row.advance <= 0.46)
      move.energy_before = std::max(move.energy_before, row.kinetic_energy);
    if (row.advance > 0.47 && row.advance <= 0.53)
      move.energy_after = std::max(move.energy_after, row.kinetic_energy);
    if (row.advance <= 0.46) move.bonds_before = row.broken_bonds;
    if (row.advance <= 0.47) move.bonds_after = row.broken_bonds;
  }
  return move;
}

}  // namespace

// The characteristic length is 0.42 m.
TEST_CASE("what a window lays ahead joins ice that is at rest, and is torn off where the sheet bends") {
  if (test_world().size() > 1) return;
  const Move far = first_move(0.50), near = first_move(0.18);
  INFO("far: " << far.energy_before << " J, " << far.bonds_before << " bonds; " << far.energy_after << " J, "
               << far.bonds_after << "; near: " << near.energy_before << ", " << near.bonds_before << "; "
               << near.energy_after << ", " << near.bonds_after);
  CHECK(far.energy_after < 2.0 * far.energy_before);
  CHECK(far.bonds_after - far.bonds_before < far.bonds_before / 10);
  // What `icebow check` warns of (study/spec/model_notes.cpp).
  CHECK(near.energy_after > 2.0 * near.energy_before);
  CHECK(near.bonds_after - near.bonds_before > near.bonds_before / 10);
}

TEST_CASE("ice at the far end does not break until it is the far end no more") {
  const Scenario s = windowed();
  const Lattice lattice = make_lattice(s);
  IceSheet sheet(s, lattice, make_partition(lattice, 0, 1),
                 make_material(s.ice, lattice.dx, s.numerics.horizon_ratio));
  const std::size_t row = sheet.layout.row(5, 1), last = row + lattice.nx - 1;
  CHECK(sheet.extra_strength[last] > 0.0);
  CHECK(sheet.extra_strength[last - block] == 0.0);
  sheet.extra_strength[row + 20] = IceSheet::crushed;
  sheet.crushed_depth[row + 20] = 0.5;
  sheet.touched_face[row + 20] = 7.0;
  sheet.drop_first_block(Communicator::serial());
  CHECK(sheet.extra_strength[last] > 0.0);
  CHECK(sheet.extra_strength[last - block] == 0.0);
  CHECK(sheet.extra_strength[row + 4] == IceSheet::crushed);
  CHECK(sheet.crushed_depth[row + 4] == 0.5);
  CHECK(sheet.touched_face[row + 4] == 7.0);
}

TEST_CASE("a window that cannot hold the bow is refused") {
  Scenario s = windowed();
  s.sheet.window_ahead = 1.27;
  CHECK_THROWS_AS(simulate(Communicator::serial(), tiny_hull(), s, {}), InputError);
}
