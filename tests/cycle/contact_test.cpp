// One contact against closed forms: a plate and a stem pressed into the edge of a floating sheet.
#include "cycle/contact_zone.h"

#include <catch2/catch.hpp>

#include "base/units.h"
#include "cycle/breaking.h"
#include "tests/cycle/panels.h"

using namespace icebow;
using namespace icebow::cycle;

namespace {

// The root is searched to 1e-4 of the load; the beam is found by 2001 samples, 0.05 % of it each.
constexpr double searched = 2e-3;  // both together, a few times

struct Bench {
  Ice ice;
  Strips strips;
  HullFront front;
  std::vector<IceStrip> sheet;
  ZoneSolver solver;

  Bench(const QuadMesh& hull, const Ice& of)
      : ice(of),
        strips(make_strips(hull, of.bottom(), of.top(), 0.02, 1.0, false)),
        front(hull, strips, ice, 2.0),
        sheet(strips.y.size()),
        solver(ice, front, strips, sheet) {}

  // The hull's waterline point of x = 0 has come to X [m]; all edges in one zone.
  Zone at(double X) {
    Zone zone;
    for (int i = 0; i < strips.count(); ++i) {
      if (front.foremost[static_cast<std::size_t>(i)] == FrontMap::none) continue;
      Touch t;
      t.strip = i;
      zone.touches.push_back(t);
    }
    solver.settle(zone, X, 2.0, 0.04);
    return zone;
  }
};

Ice with_friction(double mu) {
  Ice ice = published_ice();
  ice.friction = mu;
  return ice;
}

}  // namespace

TEST_CASE("Contact: a plate crushes as far as the floating edge lets it") {
  const double L = 4.0, slope = radians(35.0), mu = 0.1, d = 0.05;
  Bench bench(plate(L, slope, 3.0), with_friction(mu));
  const double nx = std::sin(slope), share = 1.0 - mu * nx / std::sqrt(1.0 - nx * nx);
  // F_z = p L (d - w / tan(slope)) (1 - mu n_x / sqrt(1 - n_x^2)) = k w
  const double k = bench.solver.stiffness(), p = bench.ice.p_c * L * share;
  const double w = p * d / (k + p / std::tan(slope));
  const Zone zone = bench.at(d - bench.ice.top() / std::tan(slope));
  const double beam = 2.0 * bench.strips.half_beam;  // found by samples, 0.05 % of L
  CHECK(beam == Approx(L).epsilon(1e-3));            // a sample at either side
  CHECK(zone.deflection == Approx(w).epsilon(searched));
  CHECK(zone.down == Approx(k * w).epsilon(searched));
  CHECK(zone.width == Approx(L).epsilon(searched));
  CHECK(zone.share == Approx(1.0).epsilon(1e-3));  // the root is searched to 1e-4 of the load
}

TEST_CASE("Contact: a plate that has gone through the ice bears p over the whole face") {
  const double L = 4.0, slope = radians(80.0);
  Bench bench(plate(L, slope, 4.0), with_friction(0.0));
  Zone zone = bench.at(1.0);
  const Vec3 area = zone.area;
  CHECK(area.x() == Approx(L * 1.0).epsilon(searched));
  CHECK(-area.z() == Approx(L * 1.0 / std::tan(slope)).epsilon(searched));
  CHECK(zone.down == Approx(2.6e6 * L / std::tan(slope)).epsilon(searched));
}

TEST_CASE("Contact: a sharp stem") {
  const double stem = radians(30.0), angle = radians(22.0), x = 0.6;
  Bench bench(sharp_stem(3.0, stem, angle, 3.0), with_friction(0.0));
  const double k = bench.solver.stiffness(), p = bench.ice.p_c * std::tan(angle);
  // F_z = p (x - w / tan(stem))^2 tan(angle) = k w
  double w = 0.0;
  for (int i = 0; i < 200; ++i) w = 0.5 * (w + p * std::pow(std::max(0.0, x - w / std::tan(stem)), 2) / k);
  REQUIRE(p * std::pow(x - w / std::tan(stem), 2) == Approx(k * w));
  const Zone zone = bench.at(x - bench.ice.top() / std::tan(stem));
  CHECK(zone.deflection == Approx(w).epsilon(0.01));  // strips of 0.02 m against a triangle of 0.2 m
  CHECK(zone.area.y() == Approx(0.0).margin(1e-6 * zone.area.x()));  // both sides alike, but for rounding
}

TEST_CASE("Contact: a wall crushes and pushes nothing down") {
  Bench bench(plate(4.0, pi / 2, 3.0), with_friction(0.2));
  const Zone zone = bench.at(0.1);
  CHECK(zone.down == Approx(0.0).margin(1.0));  // N, of 1 MN ahead: the rounding of cos 90 deg
  CHECK(zone.area.x() == Approx(4.0).epsilon(searched));
}

TEST_CASE("Contact: friction never lifts what the plate pushes down") {
  const Vec3 steep(std::sin(radians(85.0)), 0.0, -std::cos(radians(85.0)));
  CHECK(down_share(directions(steep, 0.3), 0.3) == Approx(0.0).margin(1e-12));  // rounding of a share of one
  const double nx = std::sin(radians(30.0));
  const Vec3 usual(nx, 0.0, -std::cos(radians(30.0)));
  CHECK(down_share(directions(usual, 0.1), 0.1) ==
        Approx(std::cos(radians(30.0)) * (1.0 - 0.1 * nx / std::sqrt(1.0 - nx * nx))));
}

TEST_CASE("Contact: an edge that was crushed deeper before bears nothing") {
  Bench bench(plate(4.0, radians(35.0), 3.0), with_friction(0.1));
  const double top = bench.ice.top() / std::tan(radians(35.0));
  for (IceStrip& strip : bench.sheet) strip.intervals()[0].memory = 0.2;
  CHECK(bench.at(0.1 - top).down == 0.0);
  const Zone zone = bench.at(0.25 - top);
  CHECK(zone.down > 0.0);
  CHECK(zone.share < 1.0);  // the edge follows the hull, without being crushed
  CHECK(zone.deflection == Approx(0.05 * std::tan(radians(35.0)))
                               .epsilon(0.01));  // the root is searched to 1e-4 of the way in a step
}
