// What makes each family what it is, read from the mesh.
#include "hullgen/bow/family.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "base/units.h"
#include "geometry/mesh_slice.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/bow_rows.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

bool within(double value, Range range) {
  return value >= range.lower - 1e-12 && value <= range.upper + 1e-12;
}

double widest(const QuadMesh& mesh, double x) {
  double y = 0.0;
  for (const Polyline& loop : slice(mesh, 0, x))
    for (const Vec3& p : loop) y = std::max(y, p.y());
  return y;
}

// Outward normals of the bow panels next to y inboard and outboard of it, by the height of their lower edge.
std::map<double, std::pair<Vec3, Vec3>> normals_beside(const QuadMesh& mesh, double y) {
  std::map<double, std::pair<Vec3, Vec3>> beside;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    if (mesh.patch[k] != Patch::bow) continue;
    const auto& q = mesh.quads[k];
    const auto& p = mesh.points;
    const Vec3 normal = (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).normalized();
    if (std::abs(p[q[1]].y() - y) < 1e-9)
      beside[p[q[0]].z()].first = normal;  // corners 0, 3 are to starboard,
    if (std::abs(p[q[0]].y() - y) < 1e-9) beside[p[q[0]].z()].second = normal;  // 1, 2 to port
  }
  return beside;
}

double angle_between(const std::pair<Vec3, Vec3>& normals) {
  return degrees(std::acos(std::min(normals.first.dot(normals.second), 1.0)));
}

}  // namespace

TEST_CASE("every family's preset lies in its ranges and has a hull with its angles, at any panel size") {
  for (const BowFamily family : all_families()) {
    const FamilyForm& form = family_form(family);
    BowParameters bow = preset_bow(family);
    CAPTURE(form.key);
    CHECK(family_of_key(form.key) == family);
    CHECK(within(bow.angles.stem, form.ranges.stem));
    CHECK(within(bow.angles.waterline, form.ranges.waterline));
    CHECK(within(bow.angles.buttock, form.ranges.buttock));
    CHECK(within(bow.angles.flare, form.ranges.flare));
    CHECK(within(bow.Lf / bow_beam(bow), form.ranges.bow_length));
    for (double cells : {0.0, 40.0, 20.0}) {
      bow.panel = cells > 0.0 ? bow.B / cells : 0.0;
      const Hull hull = make_hull(bow);
      INFO(hull.reason);
      REQUIRE(hull.status == HullStatus::ok);
      CHECK(degrees(largest_difference(bow.angles, hull.measured)) < 0.02);
    }
  }
}

TEST_CASE("panels of every preset are flat and not drawn out") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    const MeshCheck check = check_mesh(bow_mesh(preset_bow(family)));
    CHECK(check.max_warp < 0.005);
    CHECK(check.max_bow_aspect < 6.0);
  }
}

TEST_CASE("behind the bow panels are not drawn out without limit, and no column or row is lost on one side") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    BowParameters bow = preset_bow(family);
    for (double panels : {60.0, 20.0}) {
      bow.panel = bow.B / panels;
      const QuadMesh mesh = bow_mesh(bow);
      CHECK(check_mesh(mesh).max_aspect < (panels == 60.0 ? 20.0 : 25.0));
      CHECK_FALSE(place_without_mirror_image(mesh, 1e-9 * bow.B).has_value());
    }
  }
}

TEST_CASE("panels shrink where the bow turns, but not below half the wanted size") {
  BowParameters bow = preset_bow(BowFamily::flat);  // its waterline turns round the corner at the side
  bow.panel = bow.B / 20.0;
  const Row row = waterline_row(bow_mesh(bow));
  double shortest = 1e9, at = 0.0;
  for (std::size_t k = 1; k < row.size(); ++k) {
    const double length = std::hypot(row[k].along - row[k - 1].along, row[k].s - row[k - 1].s);
    if (length < shortest) shortest = length, at = row[k].along;
  }
  CHECK(at > 0.4 * bow.B);
  CHECK(shortest < 0.7 * bow.panel);
  CHECK(shortest > 0.45 * bow.panel);
}

TEST_CASE("reamers: the bow is wider than the ship, and a step that faces aft leads back") {
  const BowParameters bow = preset_bow(BowFamily::spoon_reamers);
  const Hull hull = make_hull(bow);
  CHECK(bounding_box(hull.mesh).upper.y() == Approx(bow.B / 2.0 + bow.reamer_step));
  CHECK(widest(hull.mesh, -bow.L / 2.0) == Approx(bow.B / 2.0));
  CHECK(widest(hull.mesh, -0.95 * bow.L) == Approx(bow.B / 2.0));
  double projected = 0.0;  // area of the step seen from astern, and in it no panel that faces ahead
  for (std::size_t k = 0; k < hull.mesh.quads.size(); ++k) {
    if (hull.mesh.patch[k] != Patch::reamer) continue;
    const auto& q = hull.mesh.quads[k];
    const auto& p = hull.mesh.points;
    const double x = 0.5 * (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).x();
    CHECK(x < 0.0);
    projected -= x;
  }
  CHECK(projected == Approx(2.0 * bow.reamer_step * bow.D).epsilon(1e-6));  // flat faces: rounding
}

TEST_CASE("chines: a crease from keel to deck, and none beside it") {
  const BowParameters bow = preset_bow(BowFamily::semi_spoon_chines);
  const QuadMesh mesh = bow_mesh(bow);
  const Row row = waterline_row(mesh);
  const double chine = bow.chine * bow.B / 2.0;
  const auto crease = normals_beside(mesh, chine);
  REQUIRE(crease.size() > 20);
  double inboard = 0.0;  // y of the next column towards the centreline
  for (const RowPoint& p : row)
    if (p.along < chine - 1e-9) inboard = p.along;
  const auto smooth = normals_beside(mesh, inboard);
  for (const auto& [z, normals] : crease) {
    if (z < -0.6 * bow.T) continue;  // columns are not at one y in the rounding of the bilge
    CHECK(angle_between(normals) > 3.0);
    CHECK(angle_between(smooth.at(z)) < 0.7);
  }
}

TEST_CASE("the forefoot: hollow with a concave bow, round with a spoon, straight otherwise") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    const BowParameters bow = preset_bow(family);
    const double bilge = std::min(bow.T / 4.0, bow_beam(bow) / 8.0);
    double first = 0.0, last = 0.0;  // cotangent of the quarter buttock below the belt and above the bilge
    const Row row = buttock_row(bow_mesh(bow), bow_beam(bow) / 4.0);
    for (std::size_t k = 1; k < row.size(); ++k) {
      const double slope = (row[k - 1].s - row[k].s) / (row[k].along - row[k - 1].along);
      if (row[k].along <= -bow.belt_below + 1e-9) first = slope;
      if (row[k].along <= bilge - bow.T + 1e-9) last = 0.0;
      if (row[k - 1].along >= bilge - bow.T - 1e-9 && last == 0.0) last = slope;
    }
    CHECK(last / first ==
          Approx(family_form(family).forefoot_slope).epsilon(0.06));  // slopes over a panel each: 4 % off
  }
  CHECK(family_form(BowFamily::concave).forefoot_slope < 1.0);
  CHECK(family_form(BowFamily::spoon_reamers).forefoot_slope > 1.0);
}

TEST_CASE("a high-flare bow carries its flare up to the deck, the others stand up") {
  const auto deck_edge = [](const BowParameters& bow) {
    const Row row = buttock_row(bow_mesh(bow), bow_beam(bow) / 4.0);
    const RowPoint &top = row[row.size() - 1], &below = row[row.size() - 2];
    return degrees(std::atan2(top.along - below.along, below.s - top.s));
  };
  CHECK(deck_edge(preset_bow(BowFamily::high_flare)) == Approx(45.0).margin(1e-3));  // deg: rounding
  CHECK(deck_edge(preset_bow(BowFamily::concave)) == Approx(60.0).margin(1e-3));     // deg: rounding
}

TEST_CASE("side edges lie below the middle of the section, by what the margin says") {
  const BowParameters bow = preset_bow(BowFamily::thyssen_waas_side_edges);
  const QuadMesh mesh = bow_mesh(bow);
  const Row row = waterline_row(mesh);
  double aftmost = 0.0;
  for (const RowPoint& p : row) aftmost = std::max(aftmost, p.s);
  const double edge = row.back().s, drop = (aftmost - edge) * std::tan(bow.angles.buttock);
  CHECK(edge == Approx(bow.Lf));
  CHECK(drop > 0.3);
  char words[40];
  std::snprintf(words, sizeof words, "%.2f m below the middle", drop);
  CHECK(check_feasibility(bow).margins[0].sentence.find(words) != std::string::npos);
  // In the section through the edge's point on the waterline the middle is in the air there: the edge touches
  // first.
  double highest = -1e9;
  for (const Polyline& loop : slice(mesh, 0, -bow.Lf))
    for (const Vec3& p : loop)
      if (p.y() > bow.B / 4.0 && p.y() < 0.45 * bow.B && p.z() < 2.0) highest = std::max(highest, p.z());
  CHECK(highest == Approx(drop).margin(1e-4));  // m: rounding
  const Row simplified = waterline_row(bow_mesh(thyssen_waas_bow()));
  for (std::size_t k = 1; k < simplified.size(); ++k) CHECK(simplified[k].s > simplified[k - 1].s);
}
