// What each rank says of its own particles is what one rank says of the whole sheet.
#include "solver/local_cloud.h"

#include <catch2/catch.hpp>

#include "../main.h"
#include "checkpoint_case.h"
#include "solver/sheet_state.h"
#include "solver/stepper.h"

using namespace icebow;

namespace {

// The ice some way behind first touch.
std::unique_ptr<Stepper> broken(const Communicator& comm, const Scenario& s, double advance) {
  const RunSize size = run_size(tiny_hull(), s);
  const Lattice lattice = make_lattice(s);
  auto stepper =
      std::make_unique<Stepper>(comm, tiny_hull(), s, lattice, size.dt, first_touch_x(tiny_hull(), lattice));
  while (s.V * stepper->time() < advance) stepper->step();
  return stepper;
}

// Returns the number of floes.
int check_against_gathered(Scenario s) {
  s.advance = 0.7;
  const Communicator& world = test_world();
  const auto many = broken(world, s, 0.3), one = broken(Communicator::serial(), s, 0.3);
  const SheetState whole = gather_state(Communicator::serial(), one->sheet());
  const IceCloud all = cloud(whole), own = local_cloud(world, many->sheet());
  const Layout& layout = many->sheet().layout;
  const Lattice& lattice = whole.lattice;
  std::size_t n = 0;
  int different = 0, velocities = 0;
  const auto compare_row = [&](int j, int k) {
    for (int i = layout.i0; i < std::min(lattice.nx, layout.i0 + layout.blocks * block); ++i, ++n) {
      const std::size_t id = lattice.id(i, j, k);
      REQUIRE(n < own.x.size());
      different += own.x[n] != all.x[id] || own.y[n] != all.y[id] || own.z[n] != all.z[id];
      different += own.ux[n] != all.ux[id] || own.uy[n] != all.uy[id] || own.uz[n] != all.uz[id];
      different += own.damage[n] != all.damage[id] || own.piece[n] != all.piece[id];
      velocities += own.vx[n] != 0.0f;
    }
  };
  const int below = many->sheet().lattice.mirrored_columns();
  for (int side = 0; side < many->sheet().lattice.copies(); ++side) {
    for (int j = layout.j0; j < layout.j0 + layout.columns; ++j)
      for (int k = 0; k < lattice.nz; ++k) compare_row(side == 0 ? below + j : below - 1 - j, k);
  }
  CHECK(n == own.x.size());
  CHECK(different == 0);
  std::int64_t total[2] = {std::int64_t(n), velocities};
  world.sum(total, 2);
  CHECK(total[0] == lattice.particles());
  CHECK(total[1] > 100);
  return whole.floes;
}

}  // namespace

TEST_CASE("fields and piece numbers need no gathered sheet") {
  CHECK(check_against_gathered(breaking_ice()) > 0);
}

TEST_CASE("pieces are joined across a cut along the course") {
  if (test_world().size() % 2 != 0) return;
  Scenario s = breaking_ice();
  s.numerics.ranks_along_x = 2;
  CHECK(check_against_gathered(s) > 0);
}

TEST_CASE("where no edge is held the largest piece stands") {
  Scenario s = breaking_ice();
  s.sheet.fixed = FixedEdges::none;
  check_against_gathered(s);
}

TEST_CASE("of a half model there are both sides, with the floes of either") {
  Scenario s = breaking_ice();
  s.sheet.half_model = true;
  CHECK(check_against_gathered(s) > 0);
  s.sheet.fixed = FixedEdges::none;
  check_against_gathered(s);
  if (test_world().size() % 2 != 0) return;
  s.numerics.ranks_along_x = 2;
  check_against_gathered(s);
}
