// Flat, single-curved and double-curved panels of surfaces whose curvatures are known.
#include "hullgen/hydro/shell_curvature.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "base/units.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"

using namespace icebow;

namespace {

// A grid of n x n panels over the unit square, as quads or as triangles with diagonals at random.
QuadMesh sheet(const std::function<Vec3(double, double)>& at, int n, bool triangles) {
  QuadMesh mesh;
  std::mt19937 random(1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      mesh.points.push_back(at(static_cast<double>(i) / n, static_cast<double>(j) / n));
  const auto add = [&](int a, int b, int c, int d) {
    mesh.quads.push_back({a, b, c, d});
    mesh.patch.push_back(Patch::other);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      if (!triangles)
        add(a, b, c, d);
      else if (random() % 2 == 0)
        add(a, b, c, c), add(a, c, d, d);
      else
        add(a, b, d, d), add(b, c, d, d);
    }
  return mesh;
}

// Sheets lie below z = 0 and ahead of x = -100 m.
ShellShares shares(const std::function<Vec3(double, double)>& at, bool triangles) {
  return shell_shares(sheet(at, 16, triangles), -100.0, 200.0);
}

Vec3 cylinder(double u, double v) {
  const double a = 1.5 * u;
  return Vec3(-20.0 * v, 5.0 * std::sin(a), -10.0 - 5.0 * std::cos(a));
}
Vec3 cone(double u, double v) {
  const double a = 1.5 * u, r = 3.0 + 4.0 * v;
  return Vec3(-20.0 * v, r * std::sin(a), -20.0 - r * std::cos(a));
}
Vec3 sphere(double u, double v) {
  const double a = 0.5 + u, b = 0.2 + v;
  return Vec3(8.0 * std::sin(a) * std::cos(b), 8.0 * std::sin(a) * std::sin(b), -20.0 + 8.0 * std::cos(a));
}
Vec3 plane(double u, double v) {
  return Vec3(-20.0 * v, 10.0 * u, -5.0 - 3.0 * u + v);
}
// Ruled, but twisted: not developable.
Vec3 twisted(double u, double v) {
  return Vec3(-10.0 * v, 10.0 * u, -12.0 + 5.0 * u * v);
}

}  // namespace

TEST_CASE("cylinder and cone are single-curved, a plane flat, sphere and twisted plate curved both ways") {
  for (const bool triangles : {false, true}) {
    CAPTURE(triangles);
    for (const auto& developable : {cylinder, cone}) {
      const ShellShares s = shares(developable, triangles);
      CHECK(s.single_curved == Approx(1.0).margin(1e-12));  // rounding of sums
      CHECK(s.double_curved == 0.0);
    }
    CHECK(shares(plane, triangles).flat == Approx(1.0).margin(1e-12));             // rounding of sums
    CHECK(shares(sphere, triangles).double_curved == Approx(1.0).margin(1e-12));   // rounding of sums
    CHECK(shares(twisted, triangles).double_curved == Approx(1.0).margin(1e-12));  // rounding of sums
  }
  CHECK(shares(cylinder, false).area == Approx(20.0 * 5.0 * 1.5).epsilon(1e-3));  // chords
}

TEST_CASE("the curvatures are the surface's, and converge with the panels") {
  const auto worst = [](const std::function<Vec3(double, double)>& at, int n, double larger, double smaller) {
    double off = 0.0;
    for (const PanelCurvature& c : panel_curvatures(sheet(at, n, true)))
      off = std::max({off, std::abs(std::abs(c.larger) - larger), std::abs(std::abs(c.smaller) - smaller)});
    return off;
  };
  struct Known {
    Vec3 (*at)(double, double);
    double larger, smaller;
  };
  for (const auto& [at, larger, smaller] :
       {Known{cylinder, 1.0 / 5.0, 0.0}, Known{sphere, 1.0 / 8.0, 1.0 / 8.0}}) {
    const double coarse = worst(at, 12, larger, smaller), finer = worst(at, 24, larger, smaller);
    CHECK(coarse < 0.05 * larger);  // found 0.0018: a quadratic over five panels of 7 deg
    CHECK(finer < 0.6 * coarse);
  }
}

TEST_CASE("panels at a knuckle go by their own side") {
  // Two planes that meet at 10 deg, and a cylinder that meets a plane at 40.
  const auto bent = [](double u, double v) {
    return Vec3(-20.0 * v, 10.0 * u, -10.0 + std::tan(radians(10.0)) * 10.0 * std::max(u - 0.5, 0.0));
  };
  CHECK(shares(bent, false).flat == Approx(1.0).margin(1e-12));  // rounding of sums
  const auto keeled = [](double u, double v) {
    const double a = std::min(2.0 * u, 1.0), out = 5.0 * std::sin(a) + std::max(2.0 * u - 1.0, 0.0) * 5.0;
    return Vec3(-20.0 * v, out, -10.0 - 5.0 * std::cos(a));
  };
  const ShellShares s = shares(keeled, false);
  CHECK(s.double_curved == 0.0);
  CHECK(s.flat == Approx(0.5).margin(0.01));  // areas: 5 m each, chords of the arc
}

TEST_CASE("a bow of parallel buttocks is developable but for its fan and where it rounds into the bottom") {
  // Stem and buttocks alike: there is no fan, every section below the waterline is that of one cylinder.
  BowParameters bow = preset_bow(BowFamily::straight_parallel_buttocks);
  bow.angles.stem = bow.angles.buttock;
  const QuadMesh parallel = bow_mesh(bow);
  const double straight = 10.0 * bow.B;
  const ShellShares alike = shell_shares(parallel, -bow.L / 2.0, straight);
  bow.angles.stem -= radians(6.0);
  const ShellShares fanned = shell_shares(bow_mesh(bow), -bow.L / 2.0, straight);
  CHECK(alike.double_curved < 0.05);  // where the bow's rounding meets the bottom
  CHECK(fanned.double_curved > alike.double_curved + 0.02);
  for (const ShellShares& s : {alike, fanned})
    CHECK(s.flat + s.single_curved + s.double_curved == Approx(1.0));
}
