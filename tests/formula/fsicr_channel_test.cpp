#include "formula/fsicr_channel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "base/units.h"

using namespace icebow;

namespace {

// Ship 1 of the rules' sample ships.
ChannelInputs sample_ship() {
  ChannelInputs in;
  in.L = 150.0, in.B = 25.0, in.T = 9.0, in.L_bow = 45.0, in.L_par = 70.0, in.A_wf = 500.0;
  in.waterline = radians(24.0), in.stem = radians(90.0), in.buttock = radians(30.0);
  return in;
}

ChannelResult with(double ChannelInputs::*field, double value) {
  ChannelInputs in = sample_ship();
  in.*field = value;
  return fsicr_channel(in);
}

// The rule's engine power of one controllable propeller of 5 m [kW].
double power(double resistance) {
  return 2.03 * std::pow(resistance / 1000.0, 1.5) / 5.0;
}

}  // namespace

TEST_CASE("FSICR channel: the rules' sample ship has its published powers") {
  const ChannelResult r = fsicr_channel(sample_ship());
  REQUIRE(r.valid);
  REQUIRE(r.classes.size() == 4);
  CHECK(r.caution.empty());
  const double published[] = {7840.0, 4941.0, 3478.0, 2253.0};
  for (int k = 0; k < 4; ++k)
    CHECK(power(r.classes[k].resistance) == Approx(published[k]).margin(0.5));  // published to 1 kW
}

TEST_CASE("FSICR channel: known mistakes do not pass for the rule") {
  const double right = fsicr_channel(sample_ship()).classes[1].resistance;
  CHECK(with(&ChannelInputs::buttock, radians(35.0)).classes[1].resistance > right);
  // psi in degrees in C_psi: 0.047 x 54.8 - 2.115 = 0.461 of H_F widens the channel by 10 % of the first
  // term.
  CHECK(right == Approx(529092.13).epsilon(1e-8));  // worked out apart from the code to 8 digits
}

TEST_CASE("FSICR channel: the slenderness term is bounded on both sides") {
  const double part = 825.0 * 500.0 / 150.0;
  const double shallow = with(&ChannelInputs::T, 4.5).classes[1].resistance;  // (LT/B^2)^3 = 1.26: 5
  const double deep = with(&ChannelInputs::T, 14.0).classes[1].resistance;    // 37.9: 20
  CHECK(deep - shallow == Approx(15.0 * part).epsilon(1e-12));                // rounding of a difference
}

TEST_CASE("FSICR channel: what was not validated is said, what cannot be is refused in words") {
  CHECK(with(&ChannelInputs::stem, radians(20.0)).caution ==
        "stem angle, deg is 20, the rule was validated from 25 to 90");
  CHECK(with(&ChannelInputs::B, 0.0).reason == "B is 0, must be positive");
  CHECK(with(&ChannelInputs::L_par, -1.0).reason == "L_par is -1, must not be negative");
  CHECK(with(&ChannelInputs::L_par, 130.0).reason.find("more than L") != std::string::npos);
  CHECK(with(&ChannelInputs::buttock, radians(90.0)).reason.find("below 90 deg") != std::string::npos);
  CHECK_FALSE(with(&ChannelInputs::A_wf, std::numeric_limits<double>::quiet_NaN()).valid);
  CHECK(with(&ChannelInputs::A_wf, 0.0).classes.empty());
}
