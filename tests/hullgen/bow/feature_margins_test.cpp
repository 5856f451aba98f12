// Margins and advice for reamers, chines, side edges and for angles given at B/4.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "tests/support/margins.h"

using namespace icebow;

TEST_CASE("a reamer step too small for the panels, or too large for the ship, says what would do") {
  BowParameters bow = preset_bow(BowFamily::spoon_reamers);
  bow.reamer_step = 0.05;
  REQUIRE(margin(bow, "g7").value < 0.0);
  const std::string words = margin(bow, "g7").sentence;
  CHECK(check_feasibility(bow).reason.find(words) != std::string::npos);
  BowParameters finer = bow;
  bow.reamer_step = advised(words, "raise it to");
  finer.panel = advised(words, "panel size to");
  CHECK(margin(bow, "g7").value >= -1e-3);
  CHECK(margin(finer, "g7").value >= -1e-3);
  bow.reamer_step = 3.0;
  REQUIRE(margin(bow, "g7").value < 0.0);
  bow.reamer_step = advised(margin(bow, "g7").sentence, "lower it by [0-9.]+ m to");
  CHECK(margin(bow, "g7").value >= 0.0);
}

TEST_CASE("a chine that would not show says how much longer the bow must be, or where the chine would show") {
  BowParameters bow = preset_bow(BowFamily::semi_spoon_chines);
  bow.Lf = 14.4;
  REQUIRE(margin(bow, "g7").value < 0.0);
  const std::string words = margin(bow, "g7").sentence;
  INFO(words);
  BowParameters longer = bow, moved = bow;
  longer.Lf = advised(words, "bow length Lf by [0-9.]+ m to");
  CHECK(margin(longer, "g7").value >= 0.0);
  CHECK(margin(longer, "g7").value < 0.005);
  bow.Lf = longer.Lf - 0.2;
  moved = bow;
  moved.chine = advised(margin(bow, "g7").sentence, "chine outwards to");
  CHECK(margin(moved, "g7").value >= 0.0);
  CHECK(margin(moved, "g7").value < 0.02);
}

TEST_CASE("side edges above the middle say how much shorter the bow must be, or how much less flared") {
  BowParameters bow = preset_bow(BowFamily::thyssen_waas_side_edges);
  bow.Lf = 9.0;
  REQUIRE(margin(bow, "g1").value < 0.0);
  const std::string words = margin(bow, "g1").sentence;
  BowParameters shorter = bow, upright = bow;
  shorter.Lf = advised(words, "bow length Lf by [0-9.]+ m to");
  upright.angles.flare = radians(advised(words, "flare angle from [0-9.]+ to"));
  CHECK(margin(shorter, "g1").value >= 0.0);
  CHECK(margin(shorter, "g1").value < 0.02);
  CHECK(margin(upright, "g1").value >= 0.0);
  CHECK(margin(upright, "g1").value < 0.1);
  bow.family = BowFamily::thyssen_waas;  // as the advice says
  CHECK(margin(bow, "g1").value > 0.0);
}

TEST_CASE("features that cannot be read as numbers are refused, with seven finite margins") {
  for (double bad : {0.0, -1.0, std::nan("")}) {
    BowParameters reamers = preset_bow(BowFamily::spoon_reamers),
                  chines = preset_bow(BowFamily::semi_spoon_chines);
    reamers.reamer_step = bad;
    chines.chine = bad;
    for (const BowParameters& bow : {reamers, chines}) {
      const Hull hull = make_hull(bow);
      CHECK(hull.status == HullStatus::infeasible);
      CHECK(hull.mesh.quads.empty());
      REQUIRE(hull.feasibility.margins.size() == 7);
      for (const Margin& g : hull.feasibility.margins) CHECK(std::isfinite(g.value));
      CHECK(hull.reason.find("usually") != std::string::npos);
    }
  }
}

TEST_CASE("reamer step and chine mean nothing to families that have neither") {
  BowParameters bow = preset_bow(BowFamily::flat);
  const BowFeasibility before = check_feasibility(bow);
  bow.reamer_step = bow.chine = std::nan("");
  const BowFeasibility after = check_feasibility(bow);
  REQUIRE(after.margins.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) CHECK(after.margins[k].value == before.margins[k].value);
  CHECK(bow_beam(bow) == bow.B);
}

TEST_CASE("angles given at B/4: the flare follows, and the hull has the waterline angle there") {
  for (double entrance : {24.0, 20.0}) {
    BowParameters bow = preset_bow(BowFamily::straight_parallel_buttocks);
    bow.angles_at = AnglesAt::quarter_beam;
    bow.angles = angles_at_quarter_beam(radians(25.0), radians(20.0), radians(28.0), radians(entrance));
    CHECK(std::tan(radians(20.0)) == Approx(std::tan(bow.angles.flare) * std::tan(radians(28.0))));
    const Hull hull = make_hull(bow);
    INFO(hull.reason);
    REQUIRE(hull.status ==
            HullStatus::ok);  // also where both waterline angles are the same: straight, not hollow
    CHECK(degrees(hull.waterline_at_quarter_beam) == Approx(20.0).margin(1e-4));  // deg: differences
    CHECK(degrees(hull.measured.waterline) == Approx(entrance).margin(1e-4));     // deg: differences
    CHECK(degrees(hull.measured.stem) == Approx(25.0).margin(1e-4));              // deg: differences
    CHECK(degrees(hull.measured.flare) ==
          Approx(degrees(bow.angles.flare)).margin(1e-4));  // deg: differences
  }
}

TEST_CASE("advice speaks of the waterline angle at B/4 where that is what was given") {
  BowParameters bow = preset_bow(BowFamily::straight_parallel_buttocks);
  bow.angles_at = AnglesAt::quarter_beam;
  bow.angles = angles_at_quarter_beam(radians(25.0), radians(12.0), radians(28.0), radians(20.0));
  REQUIRE(margin(bow, "g2").value < 0.0);
  const std::string words = margin(bow, "g2").sentence;
  CHECK(words.find("flare") == std::string::npos);
  const double waterline = advised(words, "waterline \\(B/4\\) angle from 12.00 to");
  bow.angles = angles_at_quarter_beam(radians(25.0), radians(waterline), radians(28.0), radians(20.0));
  CHECK(margin(bow, "g2").value >= 0.0);
  CHECK(margin(bow, "g2").value < 0.2);
}
