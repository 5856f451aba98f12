// Runs that differ in the seed alone.
#include "solver/ice/stir.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "solver/run/simulation.h"
#include "tests/support/main.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

Scenario tiny() {
  return tiny_run(1.28, 0.12);
}

RunOptions seeded(std::uint64_t seed) {
  RunOptions options;
  options.seed = seed;
  return options;
}

IceSheet stirred(const Communicator& comm, std::uint64_t seed) {
  const Scenario s = tiny();
  const Lattice lattice = make_lattice(s);
  IceSheet sheet(s, lattice, make_partition(lattice, comm.rank(), comm.size()),
                 make_material(s.ice, lattice.dx, s.numerics.horizon_ratio));
  stir(sheet, seed, s.V);
  return sheet;
}

bool same_record(const RunResult& a, const RunResult& b) {
  if (a.history.rows.size() != b.history.rows.size()) return false;
  for (std::size_t n = 0; n < a.history.rows.size(); ++n) {
    if (a.history.rows[n].F[0] != b.history.rows[n].F[0]) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("stirred ice has small random velocities, the held edge and unseeded ice none") {
  const IceSheet sheet = stirred(Communicator::serial(), 1), other = stirred(Communicator::serial(), 2),
                 still = stirred(Communicator::serial(), 0);
  const double most = stirring * 0.5;
  double sum = 0.0, square = 0.0, product = 0.0;
  int n = 0;
  for (int jl = 0; jl < sheet.layout.columns; ++jl)
    for (int l = 0; l < sheet.lattice.nx; ++l)
      for (int c = 0; c < 3; ++c) {
        const std::size_t p = sheet.layout.row(jl, 1) + l;
        const double v = sheet.v[c][p] / most, w = other.v[c][p] / most;
        CHECK_FALSE(std::abs(v) > 1.0);
        CHECK(still.v[c][p] == 0.0);
        if (!sheet.mobile(jl, l)) CHECK(v == 0.0);
        if (!sheet.mobile(jl, l)) continue;
        sum += v;
        square += v * v;
        product += v * w;
        ++n;
      }
  // Uniform: mean 0, mean square 1/3, no correlation between seeds; four standard errors.
  CHECK(std::abs(sum / n) < 4.0 * std::sqrt(1.0 / 3.0 / n));
  CHECK(square / n == Approx(1.0 / 3.0).margin(4.0 * std::sqrt(4.0 / 45.0 / n)));  // four standard errors
  CHECK(std::abs(product / n) < 4.0 / 3.0 / std::sqrt(double(n)));
}

TEST_CASE("a seed gives the same run on any number of ranks, another seed another one") {
  const RunResult one = simulate(Communicator::serial(), tiny_hull(), tiny(), seeded(1));
  REQUIRE(one.status == RunStatus::ok);
  CHECK(same_record(simulate(test_world(), tiny_hull(), tiny(), seeded(1)), one));
  CHECK_FALSE(same_record(simulate(test_world(), tiny_hull(), tiny(), seeded(2)), one));
}
