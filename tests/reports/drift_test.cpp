#include "reports/content/drift.h"

#include <catch2/catch.hpp>
#include <random>

namespace icebow {
namespace {

LoadSeries record(double slope, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  LoadSeries series;
  for (int i = 0; i < 2000; ++i) {
    series.advance.push_back(0.05 * i);
    series.load.push_back(100.0 + slope * 0.05 * i + 20.0 * gauss(random));
  }
  return series;
}

}  // namespace

TEST_CASE("a load that grows along the steady part drifts, one that scatters does not") {
  int alarms = 0;
  double growth = 0.0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    alarms += drift_of(record(0.0, seed), 20.0, 100.0).told();
    const Drift drift = drift_of(record(0.5, seed), 20.0, 100.0);
    CHECK(drift.told());
    growth += 0.01 * drift.relative;
  }
  CHECK(alarms < 15);  // 5 expected; the correlation time is an estimate too
  CHECK(growth ==
        Approx(20.0 / 120.0).epsilon(0.05));  // means 120 and 140; 100 seeds know it to half a percent
  CHECK_FALSE(drift_of({}, 0.0, 1.0).told());
}

}  // namespace icebow
