// Which rank owns which columns.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/lattice/lattice.h"

using namespace icebow;

namespace {

Lattice lattice_of(int ny, bool half) {
  Lattice l;
  l.nx = 176;
  l.ny = ny;
  l.nz = 3;
  l.dx = 0.0133;
  l.half = half;
  return l;
}

}  // namespace

TEST_CASE("columns are dealt by what they cost, and every rank gets as many as a bond reaches") {
  for (const bool half : {false, true}) {
    for (const int ranks : {1, 2, 3, 4, 7}) {
      const Lattice lattice = lattice_of(98, half);
      const std::vector<double> costs = column_costs(lattice, 0.5);
      double all = 0.0;
      for (const double cost : costs) all += cost;
      int next = 0;
      for (int rank = 0; rank < ranks; ++rank) {
        const Partition part = make_partition(lattice, rank, ranks, 1, costs);
        CHECK(part.j0 == next);
        double own = 0.0;
        for (int j = part.j0; j < part.j1; ++j) own += costs[j];
        CHECK(std::abs(own - all / ranks) <= 1.4);  // half a column at each end
        next = part.j1;
      }
      CHECK(next == lattice.ny);
    }
  }
  std::vector<double> steep(12, 1.0);
  steep[0] = 100.0;
  for (int rank = 0; rank < 4; ++rank) {
    const Partition part = make_partition(lattice_of(12, false), rank, 4, 1, steep);
    CHECK(part.j1 - part.j0 == reach);
  }
}

TEST_CASE("ice beside the ship costs more than ice far from its course, on both sides alike") {
  const Lattice lattice = lattice_of(98, false);
  const std::vector<double> costs = column_costs(lattice, 0.3);
  for (int j = 0; j < lattice.ny; ++j) {
    CHECK(costs[j] == costs[lattice.ny - 1 - j]);
    CHECK((costs[j] > 1.0) == (std::abs(lattice.y(j)) < 0.3));
  }
}
