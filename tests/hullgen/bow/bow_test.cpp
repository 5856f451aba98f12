#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/bow_surface.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

// Mean unit normal of the bow panels around a point: reads the angles in another way than measure_angles
// does.
Vec3 normal_near(const QuadMesh& mesh, const Vec3& point, bool port_only) {
  Vec3 sum = Vec3::Zero();
  for (const auto& q : mesh.quads) {
    const auto& p = mesh.points;
    bool touches = false, port = true;
    for (int corner : q) {
      touches = touches || (p[corner] - point).norm() < 1e-6;  // metres, where panels have decimetres
      port = port && p[corner].y() >= -1e-9;
    }
    if (touches && (port || !port_only)) sum += (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).normalized();
  }
  return sum.normalized();
}

QuadMesh transformed(QuadMesh mesh, const Vec3& factors) {
  for (Vec3& p : mesh.points) p = p.cwiseProduct(factors);
  return mesh;
}

}  // namespace

TEST_CASE("both bows of the paper have the angles asked for, at every panel size") {
  for (BowParameters bow : {conventional_bow(), thyssen_waas_bow()})
    for (double cells : {0.0, 40.0, 20.0, 8.0}) {  // per beam; 0 = default
      bow.panel = cells > 0.0 ? bow.B / cells : 0.0;
      const Hull hull = make_hull(bow);
      INFO(hull.reason);
      REQUIRE(hull.status == HullStatus::ok);
      CHECK(degrees(largest_difference(bow.angles, hull.measured)) < 0.02);
      CHECK(hull.feasibility.feasible);
      CHECK(hull.reason.empty());
    }
}

TEST_CASE("panel normals at the measuring points agree with the angles") {
  for (BowParameters bow : {conventional_bow(), thyssen_waas_bow()}) {
    bow.panel = bow.B / 150.0;
    const QuadMesh mesh = bow_mesh(bow);
    const BowSurface surface = bow_surface(bow);
    constexpr double beside = 0.4;  // deg: the panel of B/150 lies beside the point
    const Vec3 stem = normal_near(mesh, Vec3::Zero(), true);
    CHECK(degrees(std::atan2(stem.y(), stem.x())) ==
          Approx(90.0 - degrees(bow.angles.waterline)).margin(beside));
    CHECK(degrees(std::atan2(-stem.z(), stem.x())) == Approx(90.0 - degrees(bow.angles.stem)).margin(beside));
    const Vec3 quarter = normal_near(mesh, surface.point(bow.B / 4.0, 0.0), false);
    CHECK(degrees(std::atan2(-quarter.z(), quarter.x())) ==
          Approx(90.0 - degrees(bow.angles.buttock)).margin(1e-3));  // by differences
    CHECK(degrees(std::atan2(-quarter.z(), quarter.y())) == Approx(degrees(bow.angles.flare)).margin(beside));
  }
}

TEST_CASE("derived angles of the conventional bow") {
  const Hull hull = make_hull(conventional_bow());
  CHECK(degrees(hull.waterline_at_quarter_beam) == Approx(19.05).margin(0.01));  // given to 2 decimals
  CHECK(degrees(hull.flare_at_stem) == Approx(41.757).margin(0.01));             // waterline 22, stem 24.35
}

TEST_CASE("the feasibility margins agree with the surface itself") {
  // g1 and g3 say that every waterline widens from stem to shoulder: look at the surface instead.
  std::mt19937 random(7);
  int widening = 0, turning = 0;
  for (int k = 0; k < 2000; ++k) {
    const BowFamily family = all_families()[k % all_families().size()];
    if (!family_form(family).monotone) continue;
    const BowParameters bow = random_bow(family, random);
    const BowFeasibility f = check_feasibility(bow);
    const BowSurface surface = bow_surface(bow);
    double least = std::numeric_limits<double>::infinity();  // of dS/deta
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j < 100; ++j) {
        const double z = -bow.T + bow.D * i / 60.0, step = bow_beam(bow) / 200.0, eta = j * step;
        least = std::min(least, (surface.s(eta + step, z) - surface.s(eta, z)) / step);
      }
    const double margin = std::min(f.margins[0].value * 8.0 / bow_beam(bow), f.margins[2].value);
    if (std::abs(margin) < 0.1) continue;  // the difference quotient is not the derivative
    CHECK((least > 0.0) == (margin > 0.0));
    ++(margin > 0.0 ? widening : turning);
  }
  CHECK(widening > 200);
  CHECK(turning > 200);
}

TEST_CASE("the hull is closed, symmetric and has the main dimensions") {
  for (const BowParameters& bow : {conventional_bow(), thyssen_waas_bow()}) {
    const QuadMesh mesh = make_hull(bow).mesh;
    const Box box = bounding_box(mesh);
    CHECK(box.lower.x() == Approx(-bow.L));
    CHECK(box.upper.y() == Approx(bow.B / 2.0));
    CHECK(box.lower.y() == Approx(-bow.B / 2.0));
    CHECK(box.lower.z() == Approx(-bow.T));
    CHECK(box.upper.z() == Approx(bow.D - bow.T));
    CHECK(box.upper.x() < 12.0);  // the stem overhangs at the deck, but not by 20 m
    // Less than the block, more than the block without the whole bow.
    const double block = bow.B * bow.D;
    CHECK(enclosed_volume(mesh) < block * (bow.L + box.upper.x()));
    CHECK(enclosed_volume(mesh) > 0.95 * block * (bow.L - bow.Lf - bow.T * cot(bow.angles.buttock)));
    double moment = 0.0;
    for (const Vec3& p : mesh.points) moment += p.y();
    CHECK(moment == Approx(0.0).margin(1e-9 * mesh.points.size()));  // rounding of metres, at each point
  }
}

TEST_CASE("panels in the ice belt are of the wanted size and flat") {
  for (const BowParameters& bow : {conventional_bow(), thyssen_waas_bow()}) {
    const QuadMesh mesh = make_hull(bow).mesh;
    const double panel = panel_size(bow);
    int belt = 0;
    double shortest = 1e9, longest = 0.0, aspect = 1.0;
    for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
      if (mesh.patch[k] != Patch::bow) continue;
      double low = 1e9, high = 0.0, bottom = 1e9, top = -1e9;
      for (int e = 0; e < 4; ++e) {
        const Vec3 &a = mesh.points[mesh.quads[k][e]], &b = mesh.points[mesh.quads[k][(e + 1) % 4]];
        low = std::min(low, (a - b).norm());
        high = std::max(high, (a - b).norm());
        bottom = std::min(bottom, a.z());
        top = std::max(top, a.z());
      }
      aspect = std::max(aspect, high / low);
      if (bottom < -bow.belt_below - 1e-9 || top > bow.belt_above + 1e-9) continue;
      ++belt;
      shortest = std::min(shortest, low);
      longest = std::max(longest, high);
    }
    CHECK(belt > 1000);
    CHECK(shortest > 0.8 * panel);
    CHECK(longest < 1.3 * panel);
    CHECK(aspect < 6.0);
    CHECK(check_mesh(mesh).max_warp < 0.01);
  }
}

TEST_CASE("measuring follows a distorted hull") {
  const BowParameters bow = conventional_bow();
  const QuadMesh higher = transformed(bow_mesh(bow), Vec3(1.0, 1.0, 1.1));
  const BowAngles measured = measure_angles(higher, bow.B);
  CHECK(std::tan(measured.stem) ==
        Approx(1.1 * std::tan(bow.angles.stem)).epsilon(1e-7));  // rounding of differences
  CHECK(std::tan(measured.buttock) ==
        Approx(1.1 * std::tan(bow.angles.buttock)).epsilon(1e-7));  // rounding of differences
  CHECK(std::tan(measured.flare) ==
        Approx(std::tan(bow.angles.flare) / 1.1).epsilon(1e-7));            // rounding of differences
  CHECK(measured.waterline == Approx(bow.angles.waterline).epsilon(1e-7));  // rounding of differences
}

TEST_CASE("a mesh whose angles cannot be read is not measured") {
  QuadMesh mesh = bow_mesh(conventional_bow());
  for (Vec3& p : mesh.points) p.z() += 0.05;  // no row at the design waterline any more
  const BowAngles measured = measure_angles(mesh, conventional_bow().B);
  CHECK(std::isnan(measured.waterline));
  CHECK(std::isinf(largest_difference(measured, conventional_bow().angles)));
}

TEST_CASE("angles off by more than 0.05 deg are told with the figures") {
  const BowAngles asked = conventional_bow().angles;
  BowAngles measured = asked;
  CHECK(angle_mismatch(asked, measured) == "");
  measured.stem += radians(0.04);
  CHECK(angle_mismatch(asked, measured) == "");
  measured.stem += radians(0.02);
  CHECK(angle_mismatch(asked, measured).find("stem 24.410 / 24.350") != std::string::npos);
  measured.stem = std::numeric_limits<double>::quiet_NaN();
  CHECK(angle_mismatch(asked, measured) != "");
}

TEST_CASE("panels too coarse for a well-faired shoulder are rejected, finer ones pass") {
  BowParameters bow = conventional_bow();
  bow.Lf = 1.6 * bow.B;
  bow.angles.waterline = radians(30.0);
  bow.angles.flare = radians(40.0);
  bow.panel = bow.B / 8.0;
  const Hull coarse = make_hull(bow);
  CHECK(coarse.status == HullStatus::mesh_rejected);
  CHECK(coarse.reason.find("refine the panel size") != std::string::npos);
  CHECK(coarse.mesh.quads.empty());
  CHECK(coarse.feasibility.feasible);
  bow.panel = 0.0;
  CHECK(make_hull(bow).status == HullStatus::ok);
}
