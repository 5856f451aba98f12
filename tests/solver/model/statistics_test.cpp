#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "solver/model/statistics.h"

using namespace icebow;

namespace {

// x_k = phi x_{k-1} + e_k about the mean, started in its steady state; correlation time (1 + phi)/(1 - phi).
std::vector<double> ar1(double phi, double mean, int n, std::mt19937& engine) {
  std::normal_distribution<double> gauss;
  std::vector<double> x(n);
  double state = gauss(engine) / std::sqrt(1.0 - phi * phi);
  for (double& value : x) {
    value = mean + state;
    state = phi * state + gauss(engine);
  }
  return x;
}

double coverage(double phi, int n, int repeats) {
  std::mt19937 engine(7);
  int covered = 0;
  for (int k = 0; k < repeats; ++k) {
    const LoadStatistics s = series_statistics(ar1(phi, 5.0, n, engine));
    covered += std::abs(s.mean - 5.0) <= s.ci95;
  }
  return static_cast<double>(covered) / repeats;
}

bool has_nan(const LoadStatistics& s) {
  return std::isnan(s.mean) || std::isnan(s.ci95) || std::isnan(s.max) || std::isnan(s.q95) ||
         std::isnan(s.standard_deviation) || std::isnan(s.effective_samples);
}

}  // namespace

TEST_CASE("Statistics: the 95 % interval covers the mean of a correlated series") {
  for (const double phi : {0.0, 0.5, 0.9, 0.97}) {
    const double share = coverage(phi, 2000, 400);
    INFO("phi " << phi << " coverage " << share);
    CHECK(share > 0.92);
    CHECK(share < 0.98);
  }
  // Only six correlation times long: still not wildly optimistic.
  const double share = coverage(0.97, 400, 400);
  INFO("short, coverage " << share);
  CHECK(share > 0.88);
}

TEST_CASE("Statistics: the interval of repeats covers the mean, however few and short they are") {
  std::mt19937 engine(11);
  for (const int runs : {2, 3, 5, 10}) {
    int covered = 0, normal = 0;
    for (int k = 0; k < 2000; ++k) {
      std::vector<double> means;
      for (int r = 0; r < runs; ++r) {
        // Ten values of correlation time 20: no interval of its own would do.
        const std::vector<double> series = ar1(0.9, 5.0, 10, engine);
        means.push_back(std::accumulate(series.begin(), series.end(), 0.0) / 10.0);
      }
      const double mean = std::accumulate(means.begin(), means.end(), 0.0) / runs;
      const double half = interval_of_repeats(means);
      covered += std::abs(mean - 5.0) <= half;
      normal += std::abs(mean - 5.0) <= half * 1.96 / (runs == 2 ? 12.7062 : 4.3027);
    }
    INFO(runs << " runs: " << covered << " of 2000");
    CHECK(covered > 1870);
    CHECK(covered < 1930);
    if (runs <= 3) CHECK(normal < 1820);  // with 1.96 in the place of Student's t
  }
  CHECK(std::isinf(interval_of_repeats({5.0})));
  CHECK(interval_of_repeats({5.0, 5.0, 5.0}) == 0.0);
}

TEST_CASE("Statistics: an interval that ignored the correlation would not cover") {
  std::mt19937 engine(7);
  int covered = 0;
  for (int k = 0; k < 200; ++k) {
    const LoadStatistics s = series_statistics(ar1(0.9, 5.0, 2000, engine));
    covered += std::abs(s.mean - 5.0) <= 1.96 * s.standard_deviation / std::sqrt(2000.0);
  }
  CHECK(covered < 120);
}

TEST_CASE("Statistics: white noise and known correlation") {
  std::mt19937 engine(3);
  const LoadStatistics white = series_statistics(ar1(0.0, 0.0, 20000, engine));
  CHECK(white.ci95 ==
        Approx(1.96 / std::sqrt(20000.0)).epsilon(0.03));  // found 0.9 %: noise of the correlation time
  CHECK(white.effective_samples == Approx(20000).epsilon(0.06));  // found 3 %: likewise, doubled
  CHECK(white.effective_samples <= 20000.0);
  CHECK(white.standard_deviation == Approx(1.0).epsilon(0.03));  // its standard error is 0.5 %
  CHECK(white.q95 == Approx(1.645).epsilon(0.05));               // its standard error is 0.9 %

  const LoadStatistics red = series_statistics(ar1(0.9, 0.0, 50000, engine));
  CHECK(red.effective_samples ==
        Approx(50000.0 / 19.0).epsilon(0.15));  // found 5 %: likewise, of fewer samples
}

TEST_CASE("Statistics: plain numbers") {
  std::vector<double> values;
  for (int k = 0; k <= 100; ++k) values.push_back((37 * k) % 101);  // 0 to 100, shuffled
  const LoadStatistics s = series_statistics(values);
  CHECK(s.samples == 101);
  CHECK(s.mean == Approx(50.0));
  CHECK(s.max == 100.0);
  CHECK(s.q95 == Approx(95.0));
  CHECK(s.standard_deviation == Approx(std::sqrt(101.0 * 102.0 / 12.0)));
}

TEST_CASE("Statistics: scale and shift follow the values") {
  std::mt19937 engine(11);
  const std::vector<double> x = ar1(0.8, 1.0, 500, engine);
  std::vector<double> y = x;
  for (double& v : y) v = 1e6 * v - 3e6;
  const LoadStatistics sx = series_statistics(x), sy = series_statistics(y);
  CHECK(sy.mean == Approx(1e6 * sx.mean - 3e6));
  CHECK(sy.ci95 == Approx(1e6 * sx.ci95));
  CHECK(sy.effective_samples == Approx(sx.effective_samples));
}

TEST_CASE("Statistics: constant, short, empty and extreme series give no NaN") {
  const LoadStatistics constant = series_statistics(std::vector<double>(50, 0.1));
  CHECK(constant.mean == 0.1);
  CHECK(constant.ci95 == 0.0);
  CHECK(constant.standard_deviation == 0.0);
  CHECK(std::isinf(series_statistics({1, 2, 3, 4, 5, 6, 7}).ci95));
  CHECK(std::isfinite(series_statistics({1, 2, 3, 4, 5, 6, 7, 8}).ci95));
  CHECK(std::isinf(series_statistics({}).ci95));
  CHECK(std::isinf(series_statistics({2.0}).ci95));
  CHECK(series_statistics({2.0}).mean == 2.0);
  for (const std::vector<double>& values :
       std::vector<std::vector<double>>{{},
                                        {0},
                                        {0, 0},
                                        {1, -1},
                                        {1e200, -1e200, 3, 4, 5, 6, 7, 8, 9},
                                        {1e-310, 0, 0, 0, 0, 0, 0, 0, 0},
                                        {1, -1, 1, -1, 1, -1, 1, -1, 1, -1},
                                        {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}})
    CHECK_FALSE(has_nan(series_statistics(values)));
}

TEST_CASE("Statistics: a trend is worth few samples") {
  std::vector<double> ramp;
  for (int k = 0; k < 1000; ++k) ramp.push_back(k);
  const LoadStatistics s = series_statistics(ramp);
  CHECK(s.effective_samples < 5.0);
  CHECK(s.ci95 > 300.0);
}

TEST_CASE("Spearman's correlation with shared ranks") {
  CHECK(spearman_correlation({1, 2, 3}, {10, 100, 1000}) == Approx(1.0));
  CHECK(spearman_correlation({1, 2, 3}, {3, 2, 1}) == Approx(-1.0));
  // Ranks 1, 2.5, 2.5, 4 and 1, 2, 3, 4: sum of products 4.5, of squares 4.5 and 5: 4.5/sqrt(22.5)
  CHECK(spearman_correlation({1, 2, 2, 3}, {1, 2, 3, 4}) == Approx(4.5 / std::sqrt(22.5)));
  CHECK(std::isnan(spearman_correlation({1, 1, 1}, {1, 2, 3})));
  CHECK(std::isnan(spearman_correlation({}, {})));
}
