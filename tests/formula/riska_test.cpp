#include "formula/riska.h"

#include <catch2/catch.hpp>

#include "base/units.h"

using namespace icebow;

namespace {

RiskaInputs check_case() {
  RiskaInputs in;
  in.L = 147.2, in.B = 23.0, in.T = 8.0, in.L_par = 70.0, in.L_bow = 32.5;
  in.stem = radians(24.35), in.h = 1.0, in.V = 2.058;
  return in;
}

RiskaResult with(double RiskaInputs::*field, double value) {
  RiskaInputs in = check_case();
  in.*field = value;
  return riska_1997(in);
}

}  // namespace

TEST_CASE("Riska: check value") {
  const RiskaResult result = riska_1997(check_case());
  REQUIRE(result.valid);
  CHECK(result.total == Approx(1153.48e3).epsilon(5e-6));                       // given to 6 digits
  CHECK(result.total == Approx(result.C1 + 2.058 * result.C2).epsilon(1e-14));  // rounding of a sum
}

TEST_CASE("Riska: without speed only C1 is left") {
  const RiskaResult still = with(&RiskaInputs::V, 0.0);
  CHECK(still.total == still.C1);
}

TEST_CASE("Riska: a second ship by hand") {
  // Round numbers: 2T/B + 1 = 2, sqrt(L) = 10, phi = 10 deg.
  RiskaInputs in;
  in.L = 100, in.B = 20, in.T = 10, in.L_par = 40, in.L_bow = 30, in.stem = radians(10), in.h = 0.25,
  in.V = 2;
  const RiskaResult r = riska_1997(in);
  CHECK(r.C1 == Approx(1e3 * (0.23 * 20 * 40 * 0.25 / 2 + 1.21 * (5.725 + 2.75625 + 43.5))));
  CHECK(r.C2 == Approx(1e3 * (1.63 * (2.3625 + 3.35) + 1.55 * 0.25 * 1.6 * 40)));
}

TEST_CASE("Riska: grows with thickness, speed, beam and stem angle") {
  const double reference = riska_1997(check_case()).total;
  CHECK(with(&RiskaInputs::h, 1.2).total > reference);
  CHECK(with(&RiskaInputs::V, 3.0).total > reference);
  CHECK(with(&RiskaInputs::B, 25.0).total > reference);
  CHECK(with(&RiskaInputs::stem, radians(30.0)).total > reference);
}

TEST_CASE("Riska: guards in words") {
  CHECK(with(&RiskaInputs::T, 0.0).reason == "T is 0, must be positive");
  CHECK(with(&RiskaInputs::V, -1.0).reason == "V is -1, must not be negative");
  CHECK(with(&RiskaInputs::stem, 2.0).reason.find("must be at most 90 deg") != std::string::npos);
  CHECK(with(&RiskaInputs::L_par, 130.0).reason.find("more than L") != std::string::npos);
  CHECK_FALSE(with(&RiskaInputs::T, 0.0).valid);
}
