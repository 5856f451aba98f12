// What each rank says of its own particles is what one rank says of the whole sheet.
#include "solver/ice/local_cloud.h"

#include <catch2/catch.hpp>

#include "solver/ice/sheet_state.h"
#include "solver/step/stepper.h"
#include "tests/support/checkpoint_case.h"
#include "tests/support/main.h"

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

// Both in the same state. Returns the number of floes.
int compare(const IceSheet& many, const IceSheet& one) {
  const Communicator& world = test_world();
  const SheetState whole = gather_state(Communicator::serial(), one);
  const IceCloud all = cloud(whole), own = local_cloud(world, many);
  const Layout& layout = many.layout;
  const Lattice& lattice = whole.lattice;
  std::size_t n = 0;
  int different = 0;
  const int below = one.lattice.mirrored_columns();
  const auto place = [&](int i, int j, int k) {  // of a particle of the whole sheet, or its image
    return one.layout.row(j < below ? below - 1 - j : j - below, k) + i;
  };
  const auto compare_row = [&](int j, int k) {
    for (int i = layout.i0; i < std::min(lattice.nx, layout.i0 + layout.blocks * block); ++i, ++n) {
      const std::size_t id = lattice.id(i, j, k);
      REQUIRE(n < own.x.size());
      different += own.x[n] != all.x[id] || own.y[n] != all.y[id] || own.z[n] != all.z[id];
      different += own.ux[n] != all.ux[id] || own.uy[n] != all.uy[id] || own.uz[n] != all.uz[id];
      different += own.damage[n] != all.damage[id] || own.piece[n] != all.piece[id];
      different += own.vx[n] != static_cast<float>(one.v[0][place(i, j, k)]);
    }
  };
  for (int side = 0; side < many.lattice.copies(); ++side) {
    for (int j = layout.j0; j < layout.j0 + layout.columns; ++j)
      for (int k = 0; k < lattice.nz; ++k) compare_row(side == 0 ? below + j : below - 1 - j, k);
  }
  CHECK(n == own.x.size());
  CHECK(different == 0);
  std::int64_t total = n;
  world.sum(&total, 1);
  CHECK(total == lattice.particles());
  return whole.floes;
}

int check_against_gathered(Scenario s) {
  s.advance = 0.7;
  const auto many = broken(test_world(), s, 0.3), one = broken(Communicator::serial(), s, 0.3);
  return compare(many->sheet(), one->sheet());
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

TEST_CASE("of a half model there are both sides") {
  Scenario s = breaking_ice();
  s.sheet.half_model = true;
  check_against_gathered(s);
  s.sheet.fixed = FixedEdges::none;
  check_against_gathered(s);
}

namespace {

// Breaks what joins ice of one number to ice of another.
template <class Number>
void cut(IceSheet& sheet, const Number& number) {
  const Layout& l = sheet.layout;
  for (int jl = -reach; jl < l.columns; ++jl) {
    for (int il = -block; il < (l.blocks + 1) * block; ++il) {
      const int i = l.i0 + il, j = l.j0 + jl, b = (il + block) / block - 1;
      for (int k = 0; k < l.nz; ++k) {
        std::uint16_t* words = sheet.bits.row(jl, k) + std::ptrdiff_t(b) * sheet.bits.per_block();
        for (const Offset& o : sheet.stencil.half[k]) {
          if (number(i, j) != number(i + o.di, j + o.dj)) *words &= ~(1u << (il - b * block));
          ++words;
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("a floe across the plane of a half model is one, a floe beside it has an image") {
  Scenario s = breaking_ice();
  s.sheet.half_model = true;
  // 10 x 8 particles across the plane, 6 x 4 on port; both lie across the cut between two ranks along x.
  const auto number = [](int i, int j) {
    if (i >= 28 && i < 38 && (j < 0 ? -1 - j : j) < 4) return 1;
    return i >= 30 && i < 36 && j >= 6 && j < 10 ? 2 : 0;
  };
  for (int along : {0, 2}) {
    if (test_world().size() % 2 != 0 && along > 0) continue;
    s.numerics.ranks_along_x = along;
    const auto many = broken(test_world(), s, 0.0), one = broken(Communicator::serial(), s, 0.0);
    cut(many->sheet(), number);
    cut(one->sheet(), number);
    CHECK(compare(many->sheet(), one->sheet()) == 3);
  }
}
