// Stem radius, ice knife and skeg, read from the meshes of every family.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "base/units.h"
#include "geometry/quad_mesh.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/bow_volume.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/import/hull_measurement.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/margins.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

BowParameters fine(BowFamily family) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / 60.0;
  return bow;
}

double volume(const BowParameters& bow) {
  return enclosed_volume(bow_mesh(bow));
}

}  // namespace

TEST_CASE("a stem radius: the bow has it, and the angles asked for outside it, at any panel size") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = preset_bow(family);
    const double cosine = std::cos(bow.angles.waterline);
    for (const double half : {0.15, 0.5})
      for (const double cells : {60.0, 20.0}) {
        CAPTURE(half, cells);
        bow.centre.stem_radius = half / cosine;
        bow.panel = bow.B / cells;
        const Hull hull = make_hull(bow);
        INFO(hull.reason);
        REQUIRE(hull.status == HullStatus::ok);
        CHECK(hull.stem_radius == Approx(bow.centre.stem_radius).epsilon(1e-6));  // on vertices: rounding
        CHECK(degrees(largest_difference(bow.angles, hull.measured)) < 0.02);
        CHECK(bounding_box(hull.mesh).upper.x() > 0.0);  // the deck overhangs
        CHECK(degrees(std::atan(std::tan(hull.measured.flare) * std::tan(hull.measured.buttock))) ==
              Approx(degrees(hull.waterline_at_quarter_beam)).margin(1e-9));  // deg: the same numbers
      }
  }
}

TEST_CASE("a stem radius: any hull's measurement finds it, and the entrance outside it") {
  for (const BowFamily family :
       {BowFamily::straight_parallel_buttocks, BowFamily::concave, BowFamily::high_flare,
        BowFamily::semi_spoon_chines, BowFamily::thyssen_waas})
    for (const double radius : {0.3, 0.8}) {
      CAPTURE(family_form(family).key, radius);
      BowParameters bow = fine(family);
      const HullMeasurement sharp = measure_hull(bow_mesh(bow));
      CHECK(sharp.stem_radius == 0.0);
      bow.centre.stem_radius = radius;
      const HullMeasurement rounded = measure_hull(bow_mesh(bow));
      CHECK(rounded.stem_radius ==
            Approx(radius).epsilon(0.03));  // its nose lies between vertices of the cut
      CHECK(degrees(rounded.angles.waterline) ==
            Approx(degrees(bow.angles.waterline)).margin(0.1));  // deg: a parabola through panels
      CHECK(degrees(rounded.angles.stem) == Approx(degrees(bow.angles.stem)).margin(0.05));  // deg: alike
      CHECK(rounded.P0.x() == Approx(0.0).margin(1e-6));  // the nose is the stem: rounding
    }
}

TEST_CASE("an ice knife adds its closed form's volume, ahead of the forefoot alone") {
  BowParameters bow = fine(BowFamily::straight_parallel_buttocks);
  const double displaced = bow_displacement(bow);
  bow.centre.knife_height = 4.0;
  bow.centre.knife_width = 0.8;
  bow.centre.knife_angle = radians(70.0);
  // The wedge between stem and edge, and below the bilge's top, R above the keel, the forefoot's rounding f:
  // of half breadth (1 - f / (B/2)) b, a half of it on average from the root to the edge.
  const double H = 4.0, b = 0.4, R = 2.0, hb = bow.B / 2.0;
  const double slope = cot(bow.angles.stem) - cot(bow.centre.knife_angle);
  const double f = R * R * (1.0 - pi / 4.0), ff = R * R * R * (5.0 / 3.0 - pi / 2.0),
               zf = (H - R) * f + R * R * R / 6.0;
  const double expected = b * (slope * (H * H / 2.0 - zf / hb) + f - ff / hb);
  CHECK(bow_displacement(bow) - displaced == Approx(expected).epsilon(1e-5));  // Simpson's rule
  // Of the mesh, the difference of two angles: with and without a knife it has other rows and chords of the
  // bilge.
  BowParameters flatter = bow;
  flatter.centre.knife_angle = radians(40.0);
  const double more = b * (cot(radians(40.0)) - cot(radians(70.0))) * (H * H / 2.0 - zf / hb);
  CHECK(volume(bow) - volume(flatter) == Approx(more).epsilon(0.02));  // chords of the bilge's width
  const Hull hull = make_hull(bow);
  INFO(hull.reason);
  REQUIRE(hull.status == HullStatus::ok);
  CHECK(bounding_box(hull.mesh).lower.z() == Approx(-bow.T));
  for (const Vec3& p : hull.mesh.points)
    if (p.z() > H - bow.T)
      CHECK(-p.x() >= -1e-9 + bow_surface(bow).s_without_knife(std::min(std::abs(p.y()), hb),
                                                               std::min(p.z(), bow.D - bow.T)));
}

TEST_CASE("a skeg adds its closed form's volume under the bottom") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = fine(family);
    const double displaced = bow_displacement(bow);
    bow.centre.skeg_height = 1.0;
    bow.centre.skeg_length = 30.0;
    bow.centre.skeg_width = 0.9;
    bow.centre.skeg_angle = radians(30.0);
    const double expected = 0.45 * (30.0 - 1.0 / std::tan(radians(30.0)));
    CHECK(bow_displacement(bow) - displaced == Approx(expected).epsilon(1e-9));  // rounding
    const Hull hull = make_hull(bow);
    INFO(hull.reason);
    REQUIRE(hull.status == HullStatus::ok);
    CHECK(displaced_volume(hull.mesh, -bow.T) ==
          Approx(expected).epsilon(0.02));  // panels of its ends are split along a diagonal
    CHECK(bounding_box(hull.mesh).lower.z() == Approx(-bow.T - 1.0));
    double widest = 0.0;
    for (const Vec3& p : hull.mesh.points)
      if (p.z() < -bow.T - 0.5) widest = std::max(widest, std::abs(p.y()));
    CHECK(widest <= 0.225 + 1e-9);  // half as deep: half as wide
  }
}

TEST_CASE("the closed form's volume is the mesh's with all three, in every family") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = fine(family);
    bow.centre.stem_radius = 0.4 / std::cos(bow.angles.waterline);
    bow.centre.knife_height = 0.4 * bow.T;
    bow.centre.skeg_height = 0.8;
    bow.centre.skeg_length = 20.0;
    const Hull hull = make_hull(bow);
    INFO(hull.reason);
    REQUIRE(hull.status == HullStatus::ok);
    CHECK(displaced_volume(hull.mesh, 0.0) ==
          Approx(bow_displacement(bow)).epsilon(1e-3));  // chords of the bilge, as without
  }
}

TEST_CASE("random bows with all three have closed meshes of quads that do not cross, and their angles") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    std::mt19937 random(700u + static_cast<unsigned>(family));
    const auto in = [&](double lower, double upper) {
      return std::uniform_real_distribution<double>(lower, upper)(random);
    };
    int feasible = 0;
    for (int tried = 0; feasible < 6 && tried < 20000; ++tried) {
      BowParameters bow = random_bow(family, random);
      bow.panel = bow.B / (feasible % 2 ? 40.0 : 20.0);
      bow.centre.stem_radius = in(0.1, 1.5);
      bow.centre.knife_height = in(0.1, 0.9) * bow.T;
      bow.centre.knife_angle = radians(in(20.0, 90.0));
      bow.centre.knife_width = in(0.2, 2.0);
      bow.centre.skeg_height = in(0.1, 0.4) * bow.T;
      bow.centre.skeg_length = in(0.05, 0.8) * bow.L;
      bow.centre.skeg_width = in(0.2, 2.0);
      bow.centre.skeg_angle = radians(in(10.0, 80.0));
      if (!check_feasibility(bow).feasible) continue;
      ++feasible;
      CAPTURE(bow.L, bow.B, bow.T, bow.D, bow.Lf, bow.panel);
      CAPTURE(degrees(bow.angles.stem), degrees(bow.angles.waterline), degrees(bow.angles.buttock),
              degrees(bow.angles.flare));
      CAPTURE(bow.centre.stem_radius, bow.centre.knife_height, bow.centre.knife_width,
              degrees(bow.centre.knife_angle));
      CAPTURE(bow.centre.skeg_height, bow.centre.skeg_length, bow.centre.skeg_width,
              degrees(bow.centre.skeg_angle));
      const Hull hull = make_hull(bow);
      INFO(hull.reason);
      REQUIRE(hull.status == HullStatus::ok);
      CHECK(hull.stem_radius == Approx(bow.centre.stem_radius).epsilon(1e-4));  // differences of cubics
      CHECK(displaced_volume(hull.mesh, 0.0) ==
            Approx(bow_displacement(bow)).epsilon(5e-3));  // chords at B/20
    }
    CHECK(feasible == 6);
  }
}

TEST_CASE("advice for what stands in the centre plane suffices") {
  const BowParameters plain = preset_bow(BowFamily::straight_parallel_buttocks);
  REQUIRE(check_feasibility(plain).margins.size() == 6);
  const auto mended = [&](const char* name, double CentrePlane::*key, double bad, const std::string& after,
                          double unit = 1.0) {
    BowParameters bow = plain;
    bow.centre.stem_radius = 0.5;
    bow.centre.knife_height = 4.0;
    bow.centre.skeg_height = 1.0;
    bow.centre.skeg_length = 20.0;
    REQUIRE(check_feasibility(bow).feasible);
    bow.centre.*key = bad;
    const Margin g = margin(bow, name);
    INFO(g.sentence);
    CHECK(g.value < 0.0);
    CHECK_FALSE(check_feasibility(bow).feasible);
    bow.centre.*key = unit * advised(g.sentence, after);
    CHECK(margin(bow, name).value >= 0.0);
    CHECK(margin(bow, name).value < 0.05);
  };
  mended("g8", &CentrePlane::stem_radius, 0.005, "raise the stem radius to");
  mended("g8", &CentrePlane::stem_radius, 3.0, "lower the stem radius to");
  mended("g9", &CentrePlane::knife_height, 7.0, "lower its height to");
  mended("g9", &CentrePlane::knife_height, 0.01, "raise its height to");
  mended("g9", &CentrePlane::knife_angle, radians(15.0), "raise its angle to", radians(1.0));
  mended("g9", &CentrePlane::knife_width, 0.002, "raise its width to");
  mended("g9", &CentrePlane::knife_width, 5.0, "lower its width to");
  mended("g9", &CentrePlane::knife_width, 0.94, "make the ice knife");
  mended("g10", &CentrePlane::skeg_length, 1.5, "raise its length to");
  mended("g10", &CentrePlane::skeg_length, 140.0, "lower its length to");
  mended("g10", &CentrePlane::skeg_height, 4.5, "lower its height to");
  mended("g10", &CentrePlane::skeg_width, 0.002, "raise its width to");
}

TEST_CASE("g3's advice holds for a rounded stem, whose fan the radius moves") {
  BowParameters bow = preset_bow(BowFamily::flat);
  bow.angles.waterline = radians(70.0);
  bow.centre.stem_radius = 1.2;
  bow.angles.stem = radians(14.0);
  const std::string words = margin(bow, "g3").sentence;
  INFO(words);
  REQUIRE(margin(bow, "g3").value < 0.0);
  BowParameters steeper = bow, sharper = bow;
  steeper.angles.stem = radians(advised(words, "raise the stem angle to"));
  sharper.angles.waterline = radians(advised(words, "waterline angle from [0-9.]+ to"));
  CHECK(margin(steeper, "g3").value >= 0.0);
  CHECK(margin(steeper, "g3").value < 0.01);
  CHECK(margin(sharper, "g3").value >= 0.0);
  CHECK(margin(sharper, "g3").value < 0.01);
}

TEST_CASE("what stands in the centre plane cannot be anything but a size: every margin stays finite") {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    BowParameters bow = preset_bow(BowFamily::concave);
    bow.centre.stem_radius = bad;
    bow.centre.knife_height = 3.0;
    const BowFeasibility f = check_feasibility(bow);
    CHECK_FALSE(f.feasible);
    REQUIRE(f.margins.size() == 8);
    for (const Margin& g : f.margins) CHECK(std::isfinite(g.value));
    CHECK(f.reason.find("stem radius") != std::string::npos);
  }
}
