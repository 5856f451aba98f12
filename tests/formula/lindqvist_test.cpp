#include "formula/lindqvist.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "base/units.h"

using namespace icebow;

namespace {

// Computed independently of the code under test.
LindqvistInputs check_case() {
  LindqvistInputs in;
  in.L = 147.2, in.B = 23.0, in.T = 8.0;
  in.stem = radians(24.35), in.waterline = radians(22.0);
  in.h = 1.0, in.V = 2.058, in.sigma_f = 5e5, in.E = 2e9, in.nu = 0.3, in.mu = 0.1;
  in.rho_w = 1025.0, in.rho_i = 900.0;
  return in;
}
constexpr double check_crushing = 159152.86, check_bending = 146752.85, check_submersion = 425384.542,
                 check_total = 1229245.958;

// The conventional bow of the reference paper, full scale.
LindqvistInputs paper_case(double mu) {
  LindqvistInputs in = check_case();
  in.E = 1.3e9, in.nu = 0.33, in.mu = mu, in.rho_w = 1000.0, in.rho_i = 826.6;
  return in;
}

bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::abs(b);
}

double total_with(double LindqvistInputs::*field, double value) {
  LindqvistInputs in = check_case();
  in.*field = value;
  const LindqvistResult result = lindqvist(in);
  REQUIRE(result.valid);
  return result.total;
}

std::string reason_with(double LindqvistInputs::*field, double value) {
  LindqvistInputs in = check_case();
  in.*field = value;
  const LindqvistResult result = lindqvist(in);
  CHECK_FALSE(result.valid);
  CHECK(result.total == 0.0);
  return result.reason;
}

}  // namespace

TEST_CASE("Lindqvist: check values") {
  const LindqvistResult result = lindqvist(check_case());
  REQUIRE(result.valid);
  CHECK(result.reason.empty());
  CHECK(result.caution.empty());
  CHECK(near(result.crushing, check_crushing, 1e-6));
  CHECK(near(result.bending, check_bending, 1e-6));
  CHECK(near(result.submersion, check_submersion, 1e-6));
  CHECK(near(result.total, check_total, 1e-6));
}

TEST_CASE("Lindqvist: breaking part of the paper's conventional bow per strength") {
  const std::vector<std::array<double, 3>> mu_breaking_strength = {
      {0.00, 0.9537, 1172e3}, {0.05, 1.1210, 997e3}, {0.10, 1.2943, 863e3}, {0.16, 1.5109, 740e3}};
  for (const auto& [mu, breaking_over_sigma, strength] : mu_breaking_strength) {
    LindqvistInputs in = paper_case(mu);
    CHECK(near(lindqvist(in).breaking / in.sigma_f, breaking_over_sigma, 1e-4));
    in.sigma_f = strength;  // gives the paper's 1.1175 MN
    CHECK(near(lindqvist(in).breaking, 1.1175e6, 1e-3));
  }
}

TEST_CASE("Lindqvist: mistakes seen elsewhere do not pass the check values") {
  const LindqvistInputs in = check_case();
  const double foundation = in.E / (12.0 * (1.0 - in.nu * in.nu) * in.g * in.rho_w);
  const double psi = std::atan(std::tan(in.stem) / std::sin(in.waterline));
  const double friction = in.mu * std::cos(in.stem) / (std::sin(in.waterline) * std::cos(psi));
  const double front = in.sigma_f * in.B * std::pow(in.h, 1.5);
  const double slope = (std::tan(psi) + friction) * (1.0 + 1.0 / std::cos(psi));
  REQUIRE(near(27.0 / 64.0 * front / std::sqrt(foundation) * slope, check_bending, 1e-6));

  CHECK_FALSE(near(37.0 / 64.0 * front / std::sqrt(foundation) * slope, check_bending, 1e-2));
  CHECK_FALSE(near(27.0 / 64.0 * front / foundation * slope, check_bending, 1e-2));  // no square root
  const double brackets = std::tan(psi) + friction * (1.0 + 1.0 / std::cos(psi));
  CHECK_FALSE(near(27.0 / 64.0 * front / std::sqrt(foundation) * brackets, check_bending, 1e-2));
  const double knots = in.V / metres_per_second_per_knot;
  CHECK_FALSE(near(total_with(&LindqvistInputs::V, knots), check_total, 1e-2));
}

TEST_CASE("Lindqvist: limits") {
  SECTION("without speed the parts just add up") {
    LindqvistInputs in = check_case();
    in.V = 0.0;
    const LindqvistResult r = lindqvist(in);
    CHECK(r.breaking == r.crushing + r.bending);
    CHECK(r.total == r.breaking + r.submersion);
  }
  SECTION("at a waterline of 90 deg psi is the stem angle: a ramp") {
    LindqvistInputs in = check_case();
    in.waterline = pi / 2, in.mu = 0.0;
    const LindqvistResult r = lindqvist(in);
    REQUIRE(r.valid);
    CHECK(near(r.crushing, 0.5 * in.sigma_f * std::tan(in.stem), 1e-12));
    const double foundation = in.E / (12.0 * (1.0 - in.nu * in.nu) * in.g * in.rho_w);
    CHECK(near(r.bending,
               27.0 / 64.0 * in.sigma_f * in.B / std::sqrt(foundation) * std::tan(in.stem) *
                   (1.0 + 1.0 / std::cos(in.stem)),
               1e-12));
  }
  SECTION("ice as heavy as water needs no force to be submerged") {
    LindqvistInputs in = check_case();
    in.rho_i = in.rho_w;
    CHECK(lindqvist(in).submersion == 0.0);
  }
}

TEST_CASE("Lindqvist: monotone trends") {
  using I = LindqvistInputs;
  struct Trend {
    double I::*field;
    std::vector<double> values;
    bool rises;
  };
  const std::vector<Trend> trends = {
      {&I::h, {0.3, 0.6, 1.0, 1.5}, true},
      {&I::V, {0.0, 1.0, 2.0, 5.0}, true},
      {&I::sigma_f, {2e5, 4e5, 8e5}, true},
      {&I::mu, {0.0, 0.05, 0.1, 0.16}, true},
      {&I::B, {15.0, 20.0, 25.0}, true},
      {&I::stem, {radians(18), radians(22), radians(28), radians(35)}, true},
      {&I::waterline, {radians(17), radians(22), radians(30)}, false},
      {&I::E, {1e9, 2e9, 5e9}, false},
      {&I::rho_i, {820.0, 870.0, 920.0}, false},
  };
  for (const Trend& trend : trends)
    for (std::size_t i = 1; i < trend.values.size(); ++i) {
      const double before = total_with(trend.field, trend.values[i - 1]);
      const double after = total_with(trend.field, trend.values[i]);
      CHECK((trend.rises ? after > before : after < before));
    }
}

TEST_CASE("Lindqvist: Froude-Cauchy scaling") {
  const double lambda = 25.0;
  const LindqvistInputs full = check_case();
  LindqvistInputs model = full;
  for (double* length : {&model.L, &model.B, &model.T, &model.h}) *length /= lambda;
  model.E /= lambda, model.sigma_f /= lambda, model.V /= std::sqrt(lambda);
  CHECK(near(to_full_scale(lindqvist(model).total, lambda, scaling::force), lindqvist(full).total, 1e-12));
}

TEST_CASE("Lindqvist: guards in words") {
  using I = LindqvistInputs;
  CHECK(reason_with(&I::h, 0.0) == "h is 0, must be positive");
  CHECK(reason_with(&I::V, -1.0) == "V is -1, must not be negative");
  CHECK(reason_with(&I::E, std::numeric_limits<double>::quiet_NaN()).find("E is nan") == 0);
  CHECK(reason_with(&I::nu, 0.5).find("nu is 0.5") == 0);
  CHECK(reason_with(&I::stem, pi / 2).find("stem is 90 deg") == 0);
  CHECK(reason_with(&I::waterline, radians(91)).find("waterline is 91 deg") == 0);
  CHECK(reason_with(&I::rho_i, 1100.0).find("sinks") != std::string::npos);
  CHECK(reason_with(&I::mu, 2.0).find("does not slip") != std::string::npos);
  CHECK(reason_with(&I::L, 10.0).find("L is too short") != std::string::npos);
}

TEST_CASE("Lindqvist: caution outside sloping, wedge-shaped bows") {
  const auto caution = [](double stem_deg, double waterline_deg) {
    LindqvistInputs in = check_case();
    in.stem = radians(stem_deg), in.waterline = radians(waterline_deg);
    const LindqvistResult result = lindqvist(in);
    CHECK(result.valid);
    return result.caution;
  };
  CHECK(caution(30, 30).empty());
  CHECK(caution(14, 39).find("stem 14 deg is outside 15 to 45 deg") == 0);  // the paper's Thyssen-Waas bow
  CHECK(caution(20, 90).find("waterline 90 deg is outside 10 to 45 deg") == 0);  // flat
  CHECK(caution(14, 60).find("stem 14 deg is outside 15 to 45 deg, waterline 60 deg") == 0);
}
