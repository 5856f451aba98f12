#include "solver/ice/sheet_state.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace icebow;

namespace {

// 8 x 4 particles in one layer, a quarter of the bonds broken in the first four rows.
SheetState half_damaged() {
  SheetState state;
  state.lattice.nx = 8, state.lattice.ny = 4, state.lattice.nz = 1, state.lattice.dx = 1.0;
  state.damage.assign(32, 0.0f);
  state.piece.assign(32, 0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) state.damage[state.lattice.id(i, j, 0)] = 0.25f;
  return state;
}

}  // namespace

TEST_CASE("Damage is the mean over the particles the ship met, and no number where it met none") {
  Metrics metrics;
  measure_sheet(half_damaged(), 0.0, 8.0, 2.0, metrics);
  CHECK(metrics.mean_damage == Approx(0.125));
  measure_sheet(half_damaged(), 0.0, 4.0, 2.0, metrics);
  CHECK(metrics.mean_damage == Approx(0.25));
  measure_sheet(half_damaged(), 0.0, -1.0, 2.0, metrics);
  CHECK(std::isnan(metrics.mean_damage));
  CHECK(std::isnan(metrics.channel_width));
}
