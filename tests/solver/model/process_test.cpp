// Floes, channel, load cycles and energy of made-up fields.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "base/errors.h"
#include "solver/model/breaking_process.h"
#include "solver/model/load_cycle.h"
#include "solver/watch/detached_ice.h"

using namespace icebow;

namespace {

// A standing sheet of 48 x 20 columns of 0.1 m, 3 layers.
SheetState standing_sheet() {
  SheetState state;
  state.lattice.nx = 48;
  state.lattice.ny = 20;
  state.lattice.nz = 3;
  state.lattice.dx = 0.1;
  state.piece.assign(state.lattice.particles(), 0);
  state.damage.assign(state.lattice.particles(), 0.0f);
  return state;
}

void detach(SheetState& state, int piece, int i0, int i1, int j0, int j1, int k0 = 0) {
  for (int j = j0; j < j1; ++j)
    for (int k = k0; k < state.lattice.nz; ++k)
      for (int i = i0; i < i1; ++i) {
        state.piece[state.lattice.id(i, j, k)] = piece;
        if (piece < 0) state.damage[state.lattice.id(i, j, k)] = 1.0f;
      }
  state.floes = std::max(state.floes, piece);
}

// One floe across the window's first block and the next, one within it, dust, the channel to x = 2.4.
SheetState broken_sheet() {
  SheetState state = standing_sheet();
  detach(state, 1, 10, 30, 8, 12);
  detach(state, 2, 2, 10, 8, 12, 1);
  detach(state, -1, 0, 2, 8, 12);
  return state;
}

History record(const std::vector<double>& load) {
  History history;
  history.interval = 0.01;
  for (std::size_t n = 0; n < load.size(); ++n) {
    HistoryRow row;
    row.t = 0.01 * double(n + 1);
    row.advance = 0.5 * row.t;
    row.F[0] = -load[n];
    row.contacts = load[n] == 0.0 ? 0 : 5;
    history.rows.push_back(row);
  }
  return history;
}

}  // namespace

TEST_CASE("floes have the area, sides and thickness of their reference places") {
  DetachedIceCount count;
  count.add(broken_sheet(), 48, 0.0, 2.4);
  const DetachedIce& ice = count.total();
  REQUIRE(ice.floes.size() == 2);
  CHECK(ice.floes[0].area == Approx(2.0 * 0.4));
  CHECK(ice.floes[0].length == Approx(2.0));
  CHECK(ice.floes[0].width == Approx(0.4));
  CHECK(ice.floes[0].through == Approx(1.0));
  CHECK(ice.floes[0].x == Approx(2.0));
  CHECK(ice.floes[0].y == Approx(0.0).margin(1e-12));  // m: rounding
  CHECK(ice.floes[1].through == Approx(2.0 / 3.0));
  CHECK(ice.floes[1].area == Approx(0.8 * 0.4 * 2.0 / 3.0));
  const double dust = 2 * 4 * 3 * 1e-3;
  CHECK(ice.dust == Approx(dust));
  CHECK(ice.crushed() == Approx(dust));
  CHECK(ice.volume == Approx(dust + 20 * 4 * 3e-3 + 8 * 4 * 2e-3));
  REQUIRE(ice.channel.size() == 24);
  for (const ChannelStation& s : ice.channel) CHECK(s.width == Approx(0.4));
}

TEST_CASE("ice that a moving window drops in parts is counted once") {
  const SheetState before = broken_sheet();
  DetachedIceCount whole, parts;
  whole.add(before, 48, 0.0, 2.4);
  parts.add(before, 16, 0.0, 2.4);
  CHECK(parts.total().floes.size() == 2);  // each whole, though one reaches beyond

  SheetState after = before;  // the first block gone: what is left of the long floe counts as crushed now
  after.lattice.nx = 32;
  after.lattice.first = 16;
  after.piece.assign(after.lattice.particles(), 0);
  after.damage.assign(after.lattice.particles(), 0.0f);
  after.floes = 0;
  detach(after, -1, 0, 14, 8, 12);
  after.damage.assign(after.lattice.particles(), 0.0f);
  DetachedIceCount resumed;
  resumed.restore(parts.record());  // as a checkpoint keeps it
  resumed.add(after, 32, 0.0, 2.4);
  CHECK(resumed.total().floes.size() == whole.total().floes.size());
  CHECK(resumed.total().volume == Approx(whole.total().volume));
  CHECK(resumed.total().in_floes == Approx(whole.total().in_floes));
  CHECK(resumed.total().channel.size() == whole.total().channel.size());
  CHECK_THROWS_AS(resumed.restore({1.0, 2.0}), RuntimeError);
}

TEST_CASE("a count of broken ice whose particles, floes or stations are no whole numbers is refused") {
  DetachedIceCount count;
  count.restore({1.0, 1.0, 0.0, 0.0, 0.0, 7.0});
  CHECK(count.record().back() == 7.0);
  for (const double wrong : {2.02388e267, -1.0, 0.5, std::nan(""), double(INFINITY)}) {
    CHECK_THROWS_AS(count.restore({1.0, 1.0, 0.0, 0.0, 0.0, wrong}), RuntimeError);
    CHECK_THROWS_AS(count.restore({1.0, 1.0, 0.0, wrong, 0.0, 7.0}), RuntimeError);
    CHECK_THROWS_AS(count.restore({1.0, 1.0, 0.0, 0.0, wrong, 7.0}), RuntimeError);
  }
}

TEST_CASE("a load in cycles has their period, in noise too") {
  std::mt19937 engine(3);
  std::normal_distribution<double> gauss;
  std::vector<double> load;
  for (int n = 0; n < 1200; ++n)
    load.push_back(5.0 + std::max(0.0, 4.0 * std::sin(2.0 * M_PI * n / 90.0)) + gauss(engine));
  const LoadCycle cycle = load_cycle(record(load), 0.0);
  REQUIRE(cycle.clear);
  CHECK(cycle.period == Approx(0.9).epsilon(1e-3));  // a period of whole samples
  CHECK(cycle.advance == Approx(0.5 * cycle.period));
  CHECK(cycle.height > 0.4);
  CHECK(cycle.height > cycle.significant_above);
  CHECK(cycle.cycles == Approx(13.3).epsilon(0.01));  // 1200 samples of 90 a period, to 3 digits
}

TEST_CASE("noise, correlated or not, is seldom taken for cycles") {
  std::mt19937 engine(5);
  std::normal_distribution<double> gauss;
  for (const double phi : {0.0, 0.7, 0.95}) {
    int clear = 0;
    for (int repeat = 0; repeat < 100; ++repeat) {
      std::vector<double> load = {0.0};
      for (int n = 1; n < 900; ++n) load.push_back(phi * load.back() + gauss(engine));
      clear += load_cycle(record(load), 0.0).clear;
    }
    INFO("phi " << phi << ": " << clear << " of 100");
    CHECK(clear <= 15);
  }
}

TEST_CASE("the steady part alone counts, and time without contact is counted") {
  std::vector<double> load(100, 100.0);
  for (int n = 0; n < 100; ++n) load.push_back(n % 4 == 0 ? 8.0 : 0.0);
  const LoadCycle cycle = load_cycle(record(load), 0.5 * 0.01 * 100);
  CHECK(cycle.peak_over_mean == Approx(4.0));
  CHECK(cycle.without_contact == Approx(0.75));
  CHECK(cycle.clear);
  CHECK(cycle.period == Approx(0.04));
  const LoadCycle none = load_cycle(record(load), 99.0);
  CHECK_FALSE(none.clear);
}

TEST_CASE("the parts of the hull's work add up") {
  History history = record({1.0, 1.0, 1.0});
  HistoryRow& row = history.rows[1];
  row.hull_work = 10.0;
  row.contact_loss = 4.0;
  row.fracture = 2.0;
  row.elastic = 0.5;
  row.kinetic_energy = 1.5;
  row.potential = 1.0;
  row.balance_error = 0.25;
  const EnergyShares e = energy_shares(history);
  CHECK(e.hull_work == 10.0);
  CHECK(e.contact_loss == Approx(0.4));
  CHECK(e.fracture == Approx(0.2));
  CHECK(e.unexplained == Approx(0.025));
  // What a window has dropped is the rest: 9 J are accounted for, and 0.25 J too many.
  CHECK(e.left_astern == Approx(0.125));
  CHECK(std::isnan(energy_shares(record({1.0})).fracture));
}
