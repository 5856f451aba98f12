#include "solver/model/mean_difference.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "solver/model/statistics.h"

using namespace icebow;

TEST_CASE("two means differ by Welch's test", "[statistics]") {
  // t = 1 / 0.5 with 0.0625 / (0.0081 / 9 + 0.0256 / 4) = 8.5616 degrees of freedom; p by numerical
  // integration of Student's density.
  const MeanDifference d = mean_difference({0.0, 0.3, 9.0}, {1.0, 0.4, 4.0});
  CHECK(d.difference == 1.0);
  CHECK(d.p == Approx(0.078175).epsilon(1e-4));  // digits of the integration
  // The 95 % interval ends at 0 where p is 0.05.
  const double just = d.ci95;
  CHECK(mean_difference({0.0, 0.3, 9.0}, {just, 0.4, 4.0}).p ==
        Approx(0.05).epsilon(1e-6));  // of the root in Boost
}

TEST_CASE("what is known exactly differs or does not; what is not known is never told apart",
          "[statistics]") {
  CHECK(mean_difference(mean_estimate(1.0, 0.0, 0.0), mean_estimate(2.0, 0.0, 0.0)).p == 0.0);
  CHECK(mean_difference(mean_estimate(1.0, 0.0, 0.0), mean_estimate(1.0, 0.0, 0.0)).p == 1.0);
  const MeanEstimate unknown = mean_estimate(1.0, 0.1, 1.0), known = mean_estimate(100.0, 0.1, 50.0);
  CHECK(mean_difference(unknown, known).p == 1.0);
  CHECK(std::isinf(mean_difference(unknown, known).ci95));
  CHECK(mean_difference(mean_estimate(1.0, NAN, 30.0), known).p == 1.0);
}

TEST_CASE("equal means of correlated series are told apart once in twenty", "[statistics]") {
  std::mt19937 engine(5);
  std::normal_distribution<double> gauss;
  const auto estimate = [&] {
    std::vector<double> x(600);
    double state = 0.0;
    for (double& value : x) value = state = 0.8 * state + gauss(engine);
    const LoadStatistics s = series_statistics(x);
    return mean_estimate(s.mean, s.ci95, s.effective_samples);
  };
  int apart = 0;
  for (int i = 0; i < 400; ++i) apart += mean_difference(estimate(), estimate()).p < told_apart_below;
  CHECK(apart > 8);   // 20 expected; 2.7 standard deviations of 4.4 below
  CHECK(apart < 40);  // above: the correlation time is an estimate too, which makes errors a little small
}
