#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <regex>

#include "base/units.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

double value(const BowParameters& bow, const std::string& name) {
  for (const Margin& g : check_feasibility(bow).margins)
    if (g.name == name) return g.value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string sentence(const BowParameters& bow, const std::string& name) {
  for (const Margin& g : check_feasibility(bow).margins)
    if (g.name == name) return g.sentence;
  return "";
}

// The number that follows these words, e.g. "at least 41.2" after "flare angle from 33.00 to".
double advised(const std::string& words, const std::string& after) {
  std::smatch found;
  const std::regex pattern(after + " at (?:least|most) ([0-9.]+)");
  return std::regex_search(words, found, pattern) ? std::stod(found[1])
                                                  : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TEST_CASE("margins of the paper's bows") {
  constexpr double digits = 0.005;  // given to 2 decimals
  CHECK(value(conventional_bow(), "g1") == Approx(8.73).margin(digits));
  CHECK(value(conventional_bow(), "g2") == Approx(0.41).margin(digits));
  CHECK(value(thyssen_waas_bow(), "g1") == Approx(1.91).margin(digits));
  CHECK(value(thyssen_waas_bow(), "g2") == Approx(-0.59).margin(digits));
  CHECK(check_feasibility(conventional_bow()).feasible);
  const BowFeasibility thyssen_waas = check_feasibility(thyssen_waas_bow());
  CHECK(thyssen_waas.feasible);
  CHECK_FALSE(thyssen_waas.margins[1].required);
  CHECK(thyssen_waas.reason.empty());
}

TEST_CASE("a bow too short for its angles says how much longer, or how much more flare") {
  BowParameters bow = thyssen_waas_bow();
  bow.Lf = 6.0;
  REQUIRE(value(bow, "g1") < 0.0);
  CHECK_FALSE(check_feasibility(bow).feasible);
  const std::string words = sentence(bow, "g1");
  BowParameters longer = bow, flared = bow;
  longer.Lf = advised(words, "raise the bow length Lf by [0-9.]+ m to");
  flared.angles.flare = radians(advised(words, "flare angle from [0-9.]+ to"));
  CHECK(value(longer, "g1") >= 0.0);
  CHECK(value(longer, "g1") < 0.02);
  CHECK(value(flared, "g1") >= 0.0);
  CHECK(value(flared, "g1") < 0.1);
}

TEST_CASE("a hollow waterline is refused for parallel buttocks, with the way out") {
  BowParameters bow = conventional_bow();
  bow.Lf = 36.0;
  bow.angles.waterline = radians(18.0);  // finer at the stem than the 19.05 deg at B/4
  const std::string words = sentence(bow, "g2");
  INFO(words);
  REQUIRE(value(bow, "g2") < 0.0);
  CHECK(check_feasibility(bow).reason.find("hollow") != std::string::npos);
  bow.angles.waterline = radians(advised(words, "waterline angle to"));
  CHECK(value(bow, "g2") > -1e-9);
}

TEST_CASE("a stem too flat beside its buttocks says which stem would do") {
  BowParameters bow = conventional_bow();
  bow.angles.stem = radians(15.0);
  REQUIRE(value(bow, "g3") < 0.0);
  const std::string words = sentence(bow, "g3");
  bow.angles.stem = radians(advised(words, "stem angle to"));
  CHECK(value(bow, "g3") >= 0.0);
  CHECK(value(bow, "g3") < 0.01);
  BowParameters steep = thyssen_waas_bow();  // the other way round: above the waterline
  steep.angles.stem = radians(40.0);
  steep.angles.waterline = radians(60.0);
  REQUIRE(value(steep, "g3") < 0.0);
  steep.angles.stem = radians(advised(sentence(steep, "g3"), "stem angle to"));
  CHECK(value(steep, "g3") >= 0.0);
}

TEST_CASE("a shell longer than the forebody says how long the ship must be") {
  BowParameters bow = thyssen_waas_bow();
  bow.L = 70.0;
  REQUIRE(value(bow, "g5") < 0.0);
  const std::string words = sentence(bow, "g5");
  bow.angles.buttock = radians(advised(words, "buttock angle from [0-9.]+ to"));
  CHECK(value(bow, "g5") >= 0.0);
  CHECK(words.find("raise L by 14.15 m") != std::string::npos);  // 2 (10 + 7 cot 13 + 1.75 - 35)
}

TEST_CASE("impossible dimensions and angles are infeasible with a reason, and six finite margins") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  using Change = void (*)(BowParameters&, double);
  const Change lengths[] = {[](BowParameters& b, double v) { b.L = v; },
                            [](BowParameters& b, double v) { b.B = v; },
                            [](BowParameters& b, double v) { b.T = v; },
                            [](BowParameters& b, double v) { b.D = v; },
                            [](BowParameters& b, double v) { b.Lf = v; },
                            [](BowParameters& b, double v) { b.belt_below = v; },
                            [](BowParameters& b, double v) { b.belt_above = v; }};
  const Change angles[] = {[](BowParameters& b, double v) { b.angles.stem = v; },
                           [](BowParameters& b, double v) { b.angles.waterline = v; },
                           [](BowParameters& b, double v) { b.angles.buttock = v; },
                           [](BowParameters& b, double v) { b.angles.flare = v; }};
  const auto refused = [](const BowParameters& bow) {
    const Hull hull = make_hull(bow);
    CHECK(hull.status == HullStatus::infeasible);
    CHECK_FALSE(hull.reason.empty());
    CHECK(hull.mesh.quads.empty());
    REQUIRE(hull.feasibility.margins.size() == 6);
    for (const Margin& g : hull.feasibility.margins) CHECK(std::isfinite(g.value));
  };
  for (Change change : lengths)
    for (double bad : {nan, inf, 0.0, -1.0}) {
      BowParameters bow = conventional_bow();
      change(bow, bad);
      refused(bow);
    }
  for (Change change : angles)
    for (double bad : {nan, inf, 0.0, -0.3, radians(95.0)}) {
      BowParameters bow = conventional_bow();
      change(bow, bad);
      refused(bow);
    }
  for (double panel : {nan, -1.0, 0.001, 20.0}) {
    BowParameters bow = conventional_bow();
    bow.panel = panel;
    refused(bow);
  }
}

TEST_CASE("the reason names what to change") {
  BowParameters bow = conventional_bow();
  bow.D = 7.0;
  CHECK(check_feasibility(bow).reason.find("raise D or lower T") != std::string::npos);
  bow = conventional_bow();
  bow.angles.stem = radians(95.0);
  CHECK(check_feasibility(bow).reason.find("stem angle 95.00 deg is outside 1 to 89 deg") !=
        std::string::npos);
  CHECK(value(bow, "g6") == Approx(radians(-6.0)));
  bow = conventional_bow();
  bow.belt_above = 6.0;
  CHECK(check_feasibility(bow).reason.find("raise the depth D") != std::string::npos);
}
