#include "study/effects/response_fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace icebow {
namespace {

// Loads 1e6 + 2e5 a + 1e5 b^2 over a and b of -1 ... 1, with noise of standard deviation `noise`.
Ranking sweep(int designs, double noise) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  std::normal_distribution<double> gauss;
  std::vector<Evaluation> all;
  for (int i = 0; i < designs; ++i) {
    Evaluation e;
    e.key = e.name = "d" + std::to_string(i);
    e.status = EvaluationStatus::ok;
    const double a = even(random), b = even(random);
    e.parameters = {{"/bow/a_deg", a}, {"/bow/b_deg", b}, {"/bow/same_m", 3.0}};
    const double load = 1e6 + 2e5 * a + 1e5 * b * b + noise * gauss(random);
    e.result = {{"metrics", {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", 1e3}}}}}};
    all.push_back(e);
  }
  return rank_designs(all, "mean_load");
}

}  // namespace

TEST_CASE("a fit finds what was put in, and how far it errs") {
  const ResponseFit fit = fit_response(sweep(60, 1e4));
  REQUIRE(fit.told());
  CHECK(fit.terms == FitTerms::squares);
  REQUIRE(fit.effects.size() == 2);  // a parameter that never changes has no effect
  const Effect& a = fit.effects[0];
  CHECK(a.pointer == "/bow/a_deg");
  const double over_range = 2e5 * (a.upper - a.lower);
  CHECK(std::fabs(a.change - over_range) <
        2.0 * a.ci95);  // twice the half width: once in ten thousand missed
  CHECK(a.ci95 < 0.05 * over_range);
  CHECK(fit.left_out_error == Approx(1e4 / 1.03e6).epsilon(0.3));  // the noise; 60 designs know it to a tenth
  const Effect& b = fit.effects[1];
  CHECK(b.value.front() > b.value[b.value.size() / 2]);  // the square, from either end
  CHECK(b.value.back() > b.value[b.value.size() / 2]);
}

TEST_CASE("no fit where there are too few designs, or nothing but noise") {
  CHECK(fit_response(sweep(5, 1e3)).why ==
        "5 ranked designs are too few for 2 parameters: it takes 6 or more");
  CHECK_THAT(fit_response(sweep(14, 1e8)).why, Catch::Contains("better than the mean does"));
}

}  // namespace icebow
