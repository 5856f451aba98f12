// A feasible bow near one that is not, alone and with a displacement that is kept.
#include "study/plan/nearest_feasible.h"

#include <catch2/catch.hpp>

#include "base/units.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"

using namespace icebow;

namespace {

// A Thyssen-Waas bow whose stem is too flat beside its buttocks; advice margin by margin goes to and fro.
BowParameters ping_pong() {
  BowParameters bow = preset_bow(BowFamily::thyssen_waas);
  bow.L = 118.78, bow.B = 27.21, bow.T = 8.31, bow.D = 13.01, bow.Lf = 15.42;
  bow.angles = {radians(10.76), radians(89.98), radians(13.064), radians(87.34)};
  return bow;
}

}  // namespace

TEST_CASE("the nearest feasible bow is feasible, and near") {
  const BowParameters bow = ping_pong();
  REQUIRE_FALSE(check_feasibility(bow).feasible);
  const auto nearest = nearest_feasible(bow);
  REQUIRE(nearest);
  CHECK(check_feasibility(nearest->bow).feasible);
  CHECK(std::abs(degrees(nearest->bow.angles.stem - bow.angles.stem)) < 3.0);
  CHECK(nearest->bow.L == Approx(bow.L).epsilon(0.02));  // the ship stays: the angles are the matter
}

TEST_CASE(
    "the nearest feasible bow keeps the displacement that is held, by the dimension that is to follow") {
  const BowParameters bow = ping_pong();
  const double volume = bow_displacement(bow);
  for (const HeldBy by : {HeldBy::length, HeldBy::beam, HeldBy::draft}) {
    CAPTURE(static_cast<int>(by));
    const HeldDisplacement held{volume, by, 1.0, 500.0};
    const auto nearest = nearest_feasible(bow, held);
    REQUIRE(nearest);
    CHECK(check_feasibility(nearest->bow).feasible);
    CHECK(bow_displacement(nearest->bow) == Approx(volume).epsilon(1e-6));  // bisection
    CHECK(nearest->changes.back().find("to keep") != std::string::npos);
    if (by != HeldBy::beam) CHECK(nearest->bow.B == bow.B);
    if (by != HeldBy::draft) CHECK(nearest->bow.T == bow.T);
  }
  // Without it the displacement is another.
  CHECK(std::abs(bow_displacement(nearest_feasible(bow)->bow) / volume - 1.0) > 1e-4);
  CHECK_FALSE(nearest_feasible(bow, HeldDisplacement{100.0 * volume, HeldBy::length, 1.0, 500.0}));
}

TEST_CASE("nearest feasible bows of what stands in the centre plane keep it") {
  BowParameters bow = ping_pong();
  bow.angles.waterline = radians(70.0);
  bow.centre.stem_radius = 1.0;
  bow.centre.knife_height = 3.0;
  REQUIRE_FALSE(check_feasibility(bow).feasible);
  const auto nearest = nearest_feasible(bow);
  REQUIRE(nearest);
  CHECK(check_feasibility(nearest->bow).feasible);
  CHECK(nearest->bow.centre.stem_radius == 1.0);
}
