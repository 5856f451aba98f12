#include "cycle/breaking.h"

#include <catch2/catch.hpp>

#include "tests/cycle/panels.h"

using namespace icebow::cycle;

namespace {

Capacity plate_rule(double width_h, double edge_speed) {
  BreakingRule rule;
  rule.type = Breaking::plate;
  const Ice ice = published_ice();
  const Capacity c = capacity(ice, rule, {width_h * ice.h, 0.0, edge_speed});
  return {c.load / (ice.sigma_f * ice.h * ice.h), c.radius / ice.characteristic_length()};
}

}  // namespace

TEST_CASE("Breaking: the literature's rule") {
  const Ice ice = published_ice();
  const BreakingRule rule;
  CHECK(capacity(ice, rule, {3.0, 0.0, 0.0}).load == Approx(0.8 * 863e3));
  CHECK(capacity(ice, rule, {3.0, 0.0, 0.0}).radius == Approx(0.32 * ice.characteristic_length()));
  CHECK(capacity(ice, rule, {3.0, 1.0, 0.0}).radius == Approx(0.32 * 0.86 * ice.characteristic_length()));
  CHECK(capacity(ice, rule, {3.0, 9.0, 0.0}).radius == Approx(0.32 * 0.6 * ice.characteristic_length()));
}

TEST_CASE("Breaking: the plate's rule has the wedge's table at rest") {
  // breaking length of a truncated wedge of 90 deg over l; the formula is a straight line through the table
  const double table[][2] = {{0.5, 0.32}, {1, 0.40}, {2, 0.50}, {4, 0.60}, {8, 0.71}, {16, 0.82}};
  constexpr double line = 0.07;  // of the line: 6 % off the table at 0.5 h
  for (const auto& row : table) CHECK(plate_rule(row[0], 0.0).radius == Approx(row[1]).epsilon(line));
  CHECK(plate_rule(1000.0, 0.0).radius == Approx(1.11).epsilon(1e-3));  // a beam
  for (double width : {0.5, 1.0, 2.0, 4.0, 8.0}) {                      // C 0.65 to 0.9
    CHECK(plate_rule(width, 0.0).load > 0.6);
    CHECK(plate_rule(width, 0.0).load < 0.91);
  }
}

TEST_CASE("Breaking: a fast edge breaks short and bears more") {
  const double v = inertial_speed(published_ice());
  CHECK(v == Approx(0.19).epsilon(0.05));  // given to 2 digits
  // wedges of 8 h driven at 2, 4, 6 kn, 0.55, 1.09 and 1.64 m/s: 0.42, 0.28, 0.24 l
  CHECK(plate_rule(8.0, 0.545).radius == Approx(0.42).epsilon(0.12));  // the fit is 8 % off
  CHECK(plate_rule(8.0, 1.09).radius == Approx(0.28).epsilon(0.05));   // 2 % off
  CHECK(plate_rule(8.0, 1.64).radius == Approx(0.24).epsilon(0.08));   // 7 % off
  // of the wedge of 8 h: 1.09 over 0.52; its tip bears 0.21 at any speed
  CHECK((plate_rule(8.0, 1.09).load - 0.6) / (plate_rule(8.0, 0.0).load - 0.6) ==
        Approx((1.09 - 0.21) / (0.52 - 0.21)).epsilon(0.15));  // the load goes with the length, 10 % off
  CHECK(plate_rule(0.25, 0.01).radius == Approx(plate_rule(0.25, 0.0).radius));
}

TEST_CASE("Breaking: patch tests are met and read between") {
  const Ice ice = published_ice();
  BreakingRule rule;
  rule.type = Breaking::calibrated;
  rule.table = {{1, 0.1, 0.7, 0.5}, {1, 1.0, 0.9, 0.3}, {4, 0.1, 1.1, 0.8}, {4, 1.0, 1.5, 0.4}};
  const double load = ice.sigma_f * ice.h * ice.h, l = ice.characteristic_length();
  const auto at = [&](double width, double speed) { return capacity(ice, rule, {width, 0.0, speed}); };
  for (const PatchTest& t : rule.table) {
    CHECK(at(t.width_h, t.edge_speed).load == Approx(t.capacity * load));
    CHECK(at(t.width_h, t.edge_speed).radius == Approx(t.length_l * l));
  }
  CHECK(at(2.0, 0.1).load == Approx(0.9 * load));  // half way in the logarithm
  CHECK(at(1.0, 0.55).radius == Approx(0.4 * l));
  CHECK(at(0.1, 0.0).load == Approx(0.7 * load));  // outside: as at the border
  CHECK(at(90.0, 9.0).radius == Approx(0.4 * l));
  CHECK(largest_radius(ice, rule) == Approx(0.8 * l));
}

TEST_CASE("Breaking: a wrong value is named") {
  const BreakingRule rule;
  Voyage voyage;
  Ice ice = published_ice();
  CHECK(trouble_with(ice, voyage, rule).empty());
  ice.h = -1.0;
  CHECK(trouble_with(ice, voyage, rule) == "the ice's thickness [m] is -1, allowed 0.0001 to 100");
  ice = published_ice();
  ice.rho = 1100.0;
  CHECK(trouble_with(ice, voyage, rule).find("the ice's density [kg/m3] is 1100") == 0);
  BreakingRule empty;
  empty.type = Breaking::calibrated;
  CHECK(trouble_with(published_ice(), voyage, empty) == "there are no patch tests to break ice by");
}
