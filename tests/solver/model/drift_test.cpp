#include "solver/model/drift.h"

#include <catch2/catch.hpp>
#include <random>

namespace icebow {
namespace {

std::vector<double> record(double slope, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  std::vector<double> loads;
  for (int i = 400; i < 2000; ++i) loads.push_back(100.0 + slope * 0.05 * i + 20.0 * gauss(random));
  return loads;
}

}  // namespace

TEST_CASE("a load that grows along the steady part drifts, one that scatters does not") {
  int alarms = 0;
  double growth = 0.0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    alarms += drift_of(record(0.0, seed)).told();
    const Drift drift = drift_of(record(0.5, seed));
    CHECK(drift.told());
    growth += 0.01 * drift.relative;
  }
  CHECK(alarms < 15);  // 5 expected; the correlation time is an estimate too
  CHECK(growth ==
        Approx(20.0 / 120.0).epsilon(0.05));  // means 120 and 140; 100 seeds know it to half a percent
}

TEST_CASE("a record that is too short does not drift, and what was not tested is not told") {
  CHECK_FALSE(drift_of({}).told());
  CHECK(drift_of({1.0, 2.0, 3.0}).p == 1.0);
  CHECK_FALSE(Drift().told());
}

}  // namespace icebow
