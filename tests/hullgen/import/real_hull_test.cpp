// Hulls as yards and CAD programs export them, small: a wedge bow of known planes and its variants.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/errors.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/import/hull_stations.h"
#include "hullgen/import/imported_hull.h"
#include "hullgen/import/offsets.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/scratch.h"

using namespace icebow;

namespace {

// 18 m beam on the waterline, 80 m long, 10 m deep; the bow's plane has waterline 21.801, buttock 26.565,
// flare 38.660 deg. Panels as lines of an OBJ file.
const std::string points =
    "v -10 0 -5\nv -30 8 -5\nv -30 -8 -5\nv -80 8 -5\nv -80 -8 -5\nv 10 0 5\nv -15 10 5\nv -15 -10 5\nv -80 "
    "10 5\nv -80 -10 5\n";
const std::string sides = "f 2 7 6 1\nf 6 8 3 1\nf 4 9 7 2\nf 8 10 5 3\n", bottom = "f 3 5 4 2 1\n",
                  deck = "f 7 9 10 8 6\n", transom = "f 5 10 9 4\n";
const std::string base = points + sides + bottom + deck + transom;
constexpr double base_volume = 5479.1667;  // under z = 0

std::string box(int first, const Vec3& low, const Vec3& high, std::string& panels) {
  std::string v;
  for (int k = 0; k < 8; ++k)
    v += "v " + std::to_string(k & 4 ? high.x() : low.x()) + " " +
         std::to_string(k & 2 ? high.y() : low.y()) + " " + std::to_string(k & 1 ? high.z() : low.z()) + "\n";
  for (const auto& q : {std::array<int, 4>{0, 1, 3, 2},
                        {4, 6, 7, 5},
                        {0, 4, 5, 1},
                        {2, 3, 7, 6},
                        {0, 2, 6, 4},
                        {1, 5, 7, 3}}) {
    panels += "f";
    for (const int k : q) panels += " " + std::to_string(first + k);
    panels += "\n";
  }
  return v;
}
// The base with boxes: corners low and high of each.
std::string with_boxes(const std::vector<std::pair<Vec3, Vec3>>& boxes) {
  std::string v = points, f = sides + bottom + deck + transom;
  int first = 11;
  for (const auto& [low, high] : boxes) v += box(first, low, high, f), first += 8;
  return v + f;
}

ImportedHull imported(const std::string& obj, const ImportChoice& choice = {}, const MeshFrame& frame = {}) {
  const Scratch scratch("real_hull");
  std::ofstream(scratch.path() + "/hull.obj") << obj;
  return import_hull(scratch.path() + "/hull.obj", frame, choice);
}
std::string refusal(const std::string& obj, const ImportChoice& choice = {}) {
  try {
    imported(obj, choice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
std::string told(const ImportedHull& hull) {
  std::string all;
  for (const std::string& words : in_words(hull.repairs)) all += words + "\n";
  for (const std::string& words : hull.repairs.warnings) all += "warning: " + words + "\n";
  return all;
}

void check_base(const ImportedHull& hull, double volume = base_volume) {
  INFO(told(hull));
  const BowAngles& a = hull.measured.angles;
  constexpr double moved = 0.01;  // deg: planes, but for digits of the file and what was moved to mend it
  CHECK(degrees(a.stem) == Approx(26.565).margin(moved));
  CHECK(degrees(a.waterline) == Approx(21.801).margin(moved));
  CHECK(degrees(a.buttock) == Approx(26.565).margin(moved));
  CHECK(degrees(a.flare) == Approx(38.660).margin(moved));
  CHECK(degrees(largest_difference(a, hull.measured.starboard)) < moved);
  CHECK(degrees(hull.measured.spread.flare) < moved);
  CHECK(displaced_volume(hull.mesh, 0.0) ==
        Approx(volume).epsilon(1e-3));  // a half hull may be 2 mm off its centre plane
  CHECK(check_mesh(hull.mesh).ok());
}

}  // namespace

TEST_CASE("a plane panel gives its plane") {
  const ImportedHull hull = imported(base);
  check_base(hull);
  constexpr double digits = 0.001;  // deg: angles are given to 3 decimals
  CHECK(degrees(hull.measured.waterline_at_quarter_beam) == Approx(21.801).margin(digits));
  CHECK(hull.measured.stem_radius == 0.0);
  for (const double z : {0.0, -2.0}) {
    const WaterlineAngles line = angles_along_waterline(hull.mesh, z);
    REQUIRE(line.stations.size() == station_shares().size());
    for (const StationAngles& s : line.stations) {
      CHECK(degrees(s.flare) == Approx(38.660).margin(digits));
      CHECK(degrees(s.waterline) == Approx(21.801).margin(digits));
      CHECK(degrees(s.normal_flare) == Approx(36.60).margin(0.01));  // atan(tan 38.660 cos 21.801)
      CHECK(degrees(s.plate_slope) == Approx(90.0 - degrees(s.normal_flare)));
    }
  }
}

TEST_CASE("a shoulder and a transom beside the place are no part of the waterline's slope") {
  // Every side panel cut along the diagonal that crosses the waterline, as an STL has them.
  check_base(imported(points + "f 2 7 6\nf 2 6 1\nf 6 8 3\nf 6 3 1\nf 4 9 7\nf 4 7 2\nf 8 10 5\nf 8 5 3\n" +
                      bottom + deck + transom));
  check_base(imported(points + "f 2 7 1\nf 7 6 1\nf 6 8 1\nf 8 3 1\nf 4 9 2\nf 9 7 2\nf 8 10 3\nf 10 5 3\n" +
                      bottom + deck + transom));
}

TEST_CASE("in any unit and direction the base is the same hull") {
  // Millimetres, the bow towards -z, y up, keel 3 m above the file's zero.
  std::string turned, letter;
  std::istringstream words(points);
  for (double x = 0.0, y = 0.0, z = 0.0; words >> letter >> x >> y >> z;)
    turned += "v " + std::to_string(-1000.0 * y) + " " + std::to_string(1000.0 * (z + 8.0)) + " " +
              std::to_string(-1000.0 * x) + "\n";
  MeshFrame frame;
  frame.unit = 0.001;
  frame.forward = -Vec3::UnitZ();
  frame.up = Vec3::UnitY();
  frame.waterline = 8.0;
  check_base(imported(turned + sides + bottom + deck + transom, {}, frame));
}

TEST_CASE("two quads that share two edges, panels without shared corners, walls") {
  const std::string doublet = "v -56 0 -5\nv -54 0 -5\nv -55 0 -5\n";
  check_base(imported(points + doublet + sides + deck + transom +
                      "f 11 13 12 2\nf 11 3 12 13\nf 12 1 2\nf 12 3 1\nf 11 2 4\nf 11 4 5\nf 11 5 3\n"));
  const ImportedHull junction =
      imported(points + "v -55 8 -5\n" + sides + "f 3 5 4 11 2 1\n" + deck + transom);
  check_base(junction);
  CHECK_THAT(told(junction), Catch::Contains("T-junction"));
  const ImportedHull wall = imported(base + "v -50 0 0\nf 2 3 11\n");  // joins the bottom's edge
  check_base(wall);
  const ImportedHull bulkhead =
      imported(points + "v -50 8 -5\nv -50 -8 -5\nv -50 10 5\nv -50 -10 5\n" +
               "f 2 7 6 1\nf 6 8 3 1\nf 11 13 7 2\nf 4 9 13 11\nf 8 14 12 3\nf 14 10 5 12\n"
               "f 3 12 11 2 1\nf 12 5 4 11\nf 7 13 14 8 6\nf 13 9 10 14\nf 5 10 9 4\nf 11 12 14 13\n");
  check_base(bulkhead);
  CHECK_THAT(told(bulkhead), Catch::Contains("walls inside"));
}

TEST_CASE("holes with one sensible lid are closed, others refused with their size") {
  const ImportedHull no_deck = imported(points + sides + bottom + transom);
  check_base(no_deck);
  CHECK_THAT(told(no_deck), Catch::Contains("hole") && Catch::Contains("filled"));
  check_base(imported(points + sides + bottom + deck));
  const ImportedHull wall_at_rim = imported(points + "v -50 0 0\n" + sides + bottom + transom + "f 9 7 11\n");
  check_base(wall_at_rim);
  CHECK_THAT(told(wall_at_rim), Catch::Contains("hung free at the rim"));
  CHECK_THAT(refusal(points + "f 2 7 6 1\nf 6 8 3 1\n" + deck + transom),
             Catch::Contains("not closed") && Catch::Contains("m across"));
}

TEST_CASE("half hulls: tolerance at the centre plane, and no lid there by mistake") {
  const auto half = [](double off, double wave) {
    const auto number = [](double v) { return std::to_string(v); };
    return "v -10 " + number(off) + " -5\nv -30 8 -5\nv -80 8 -5\nv 10 " + number(off + wave) +
           " 5\nv -15 10 5\nv -80 10 5\nv -80 " + number(off) + " -5\nv -80 " + number(off + wave) +
           " 5\nf 2 5 4 1\nf 3 6 5 2\nf 7 3 2 1\nf 5 6 8 4\nf 7 8 6 3\n";
  };
  ImportChoice mirror;
  mirror.mirror = true;
  check_base(imported(half(0.0, 0.0), mirror));
  const ImportedHull off = imported(half(0.002, 0.0), mirror), wavy = imported(half(0.0, 0.001), mirror);
  check_base(off);
  check_base(wavy);
  CHECK_THAT(told(off), Catch::Contains("centre plane, by up to 2 mm"));
  CHECK_THAT(refusal(half(0.0, 0.0)), Catch::Contains("--mirror"));
  CHECK_THAT(refusal(half(0.1, 0.0), mirror), Catch::Contains("0.1 m of the centre plane"));
}

TEST_CASE("warped panels with two equal diagonals are cut alike on both sides") {
  ImportChoice mirror;
  mirror.mirror = true;
  const ImportedHull hull = imported(
      "v 0 0 -5\nv 0 8 -5\nv -80 9 -5\nv -80 0 -5\nv 0 0 5\nv 0 9 5\nv -80 8 5\nv -80 0 5\nf 2 3 7 6\nf 1 2 "
      "6 5\nf 3 4 8 7\n"
      "f 1 4 3 2\nf 5 6 7 8\n",
      mirror);
  CHECK(hydrostatics(hull.mesh, {}, 1025.0).buoyancy.y() == Approx(0.0).margin(1e-9));  // m: rounding
}

TEST_CASE("surfaces inside, overlapping or touching are resolved and named") {
  const ImportedHull tank = imported(with_boxes({{{-70, -3, -2}, {-60, 3, 2}}}));
  check_base(tank);
  CHECK_THAT(told(tank), Catch::Contains("lies inside another, at (-"));
  const ImportedHull house = imported(with_boxes({{{-70, -3, 5}, {-60, 3, 12}}}));
  check_base(house);
  CHECK_THAT(told(house), Catch::Contains("united"));
  const ImportedHull mast = imported(with_boxes({{{-70, -3, 6}, {-60, 3, 9}}, {{-65, -2, 7}, {-55, 2, 8}}}));
  check_base(mast);
  const ImportedHull skeg = imported(with_boxes({{{-75, -0.5, -6}, {-65, 0.5, -4}}}));
  check_base(skeg, base_volume + 10.0);  // 10 m3 of it lie outside
  const ImportedHull crane = imported(with_boxes({{{-70, 3, 6}, {-60, 13, 7}}}));
  check_base(crane);
}

TEST_CASE("an open boat with its plating is refused, and its outer surface taken where asked for") {
  const std::string boat = points +
                           "v -14 0 -4.5\nv -30.5 7.4 -4.5\nv -30.5 -7.4 -4.5\nv -79.5 7.4 -4.5\nv -79.5 "
                           "-7.4 -4.5\nv 7 0 5\nv -15.5 9.2 5\n"
                           "v -15.5 -9.2 5\nv -79.5 9.2 5\nv -79.5 -9.2 5\n" +
                           sides + bottom + transom +
                           "f 11 16 17 12\nf 11 13 18 16\nf 12 17 19 14\nf 13 15 20 18\nf 11 12 14 15 13\nf "
                           "14 19 20 15\nf 7 9 19 17\nf 9 10 20 19\n"
                           "f 10 8 18 20\nf 8 6 16 18\nf 6 7 17 16\n";
  CHECK_THAT(refusal(boat), Catch::Contains("loop inside a loop") && Catch::Contains("--outer"));
  ImportChoice outer;
  outer.outer_surface = true;
  check_base(imported(boat, outer));
}

TEST_CASE("vertical is a flare of 0; angles no icebreaker has are marked") {
  std::string f;
  const std::string v = box(1, {-80, -8, -5}, {0, 8, 5}, f);
  const ImportedHull vertical = imported(v + f);
  CHECK(degrees(vertical.measured.angles.flare) == Approx(0.0).margin(1e-9));  // rounding
  CHECK(degrees(vertical.measured.angles.stem) == Approx(90.0));
  const ImportedHull home = imported(
      "v -10 0 -5\nv -30 10 -5\nv -30 -10 -5\nv -80 10 -5\nv -80 -10 -5\nv -20 0 5\nv -36 8 5\nv -36 -8 5\nv "
      "-80 8 5\n"
      "v -80 -8 5\n" +
      sides + bottom + deck + transom);
  CHECK(degrees(home.measured.angles.stem) == Approx(135.0));
  CHECK_THAT(told(home), Catch::Contains("warning: the stem angle of 135"));
}

TEST_CASE("sides that differ are told, with both sides' angles") {
  const ImportedHull hull = imported(
      "v -10 0 -5\nv -22 8 -5\nv -30 -8 -5\nv -72 8 -5\nv -80 -8 -5\nv 10 0 5\nv -7 10 5\nv -15 -10 5\nv -72 "
      "10 5\nv -80 -10 5\n" +
      sides + bottom + deck + transom);
  CHECK_THAT(told(hull), Catch::Contains("the two sides differ") && Catch::Contains("starboard has"));
  CHECK(told(imported(base)).find("differ") == std::string::npos);
}

TEST_CASE("the entrance is read outside the stem bar, whose radius is told") {
  // Rows of points round the bar and along the sides of the wedge: waterline 21.801 deg, at every height
  // alike.
  const double alpha = std::atan2(9.0, 22.5);
  for (const double r : {0.05, 0.2, 0.5})
    for (const int around : {6, 12}) {
      std::string v, f;
      std::vector<std::pair<double, double>> line;  // x, y of the waterline from stem to shoulder
      const double centre = -r / std::sin(alpha);   // the sides, extended, meet in x = 0
      for (int k = 0; k <= around; ++k) {
        const double turn = (0.5 * pi - alpha) * k / around;
        line.push_back({centre + r * std::cos(turn), r * std::sin(turn)});
      }
      const auto [x0, y0] = line.back();
      for (int k = 1; k <= 10; ++k)
        line.push_back({x0 + (-22.5 - x0) * k / 10.0, y0 + (9.0 - y0) * k / 10.0});
      line.push_back({-80.0, 9.0});
      line.push_back({-80.0, 0.0});
      const int n = static_cast<int>(line.size());
      for (int level = 0; level <= 8; ++level)
        for (const auto& [x, y] : line)
          v += "v " + std::to_string(x + (x > -79.0 ? 2.0 * (level - 4) : 0.0)) + " " + std::to_string(y) +
               " " + std::to_string(level - 4) + "\n";
      const auto panel = [&](int a, int b, int c, int d) {
        f += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + " " +
             std::to_string(d + 1) + "\n";
      };
      for (int level = 0; level < 8; ++level)
        for (int k = 0; k + 1 < n; ++k)
          panel(level * n + k, level * n + k + 1, (level + 1) * n + k + 1, (level + 1) * n + k);
      for (const int level : {0, 8}) {
        f += "f";
        for (int k = 0; k < n; ++k) f += " " + std::to_string(level * n + k + 1);
        f += "\n";
      }
      ImportChoice mirror;
      mirror.mirror = true;
      const ImportedHull hull = imported(v + f, mirror);
      INFO(r << " " << around);
      CHECK(degrees(hull.measured.angles.waterline) ==
            Approx(degrees(alpha)).margin(0.3));                    // deg: the bound asked for
      CHECK(hull.measured.stem_radius == Approx(r).epsilon(0.05));  // the chords' sagitta
    }
}

TEST_CASE("offsets written and read back are the same hull") {
  const Scratch scratch("offsets");
  const ImportedHull hull = imported(base);
  std::ofstream(scratch.path() + "/hull.csv") << offsets_csv(offsets_of(hull.mesh));
  const ImportedHull back = import_hull(scratch.path() + "/hull.csv", {});
  // A table's straight lines between waterlines are the hull's own here.
  constexpr double at_ends = 0.2;  // deg: but for a ten-thousandth of depth at the ends
  CHECK(displaced_volume(back.mesh, 0.0) == Approx(base_volume).epsilon(2e-3));  // likewise
  CHECK(degrees(back.measured.angles.stem) == Approx(26.565).margin(at_ends));
  CHECK(degrees(back.measured.angles.flare) == Approx(38.660).margin(at_ends));
  CHECK(offsets_csv(read_offsets(scratch.path() + "/hull.csv")) == offsets_csv(offsets_of(hull.mesh)));
  std::ofstream(scratch.path() + "/bad.csv") << "x_m,-5,0\n0,1,x\n";
  CHECK_THROWS_WITH(import_hull(scratch.path() + "/bad.csv", {}), Catch::Contains("bad.csv, line 2"));
}

TEST_CASE("offsets of a box, as a person types them: ends left out, stations in any order") {
  const Scratch scratch("typed_offsets");
  const std::string path = scratch.path() + "/box.csv";
  std::ofstream(path) << "# a barge\nx_m,-4,-2,0,3\n-40,5,5,5,5\n0,5,5,5,5\n-20,5,5,5,5\n";
  const Offsets offsets = read_offsets(path);
  CHECK(offsets.x == std::vector<double>{0.0, -20.0, -40.0});
  const ImportedHull barge = import_hull(path, {});
  CHECK(enclosed_volume(barge.mesh) == Approx(40.0 * 10.0 * 7.0));
  CHECK(barge.T == Approx(4.0));
  const auto refused = [&](const char* table, const char* why) {
    std::ofstream(path) << table;
    CHECK_THROWS_WITH(read_offsets(path), Catch::Contains("box.csv") && Catch::Contains(why));
  };
  refused("x_m,-4,0\n0,5,-1\n", "line 2");
  refused("x_m,-4,0\n0,5,5\n-9,5,5\n0,5,5\n", "there twice");
  refused("x_m,-4,0\n0,5,5,5\n-9,5,5\n", "line 2");
  refused("", "box.csv");
}
