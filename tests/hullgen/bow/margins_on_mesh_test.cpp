// The closed forms g1 to g7 against the meshes they speak about: random bows of every family.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "hullgen/mesh/mesh_check.h"
#include "tests/support/bow_rows.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

double value(const BowFeasibility& f, const std::string& name) {
  for (const Margin& g : f.margins)
    if (g.name == name) return g.value;
  return std::nan("");
}

// Slopes ds/dy of the design waterline, panel by panel.
std::vector<double> slopes(const Row& row) {
  std::vector<double> result;
  for (std::size_t k = 1; k < row.size(); ++k)
    result.push_back((row[k].s - row[k - 1].s) / (row[k].along - row[k - 1].along));
  return result;
}

double largest_decrease(const std::vector<double>& values) {
  double decrease = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) decrease = std::max(decrease, values[k - 1] - values[k]);
  return decrease;
}

double aft_end(const QuadMesh& mesh, Patch patch) {
  double end = 0.0;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    if (mesh.patch[k] == patch)
      for (const int corner : mesh.quads[k]) end = std::max(end, -mesh.points[corner].x());
  return end;
}

}  // namespace

TEST_CASE("random feasible bows of every family give their angles back at two panel sizes") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    std::mt19937 random(100u + static_cast<unsigned>(family));
    int feasible = 0;
    double worst = 0.0;
    for (int tried = 0; feasible < 40 && tried < 10000; ++tried) {
      BowParameters bow = random_bow(family, random);
      if (!check_feasibility(bow).feasible) continue;
      ++feasible;
      for (double cells : {40.0, 20.0}) {
        bow.panel = bow.B / cells;
        const QuadMesh mesh = bow_mesh(bow);
        worst = std::max(worst, degrees(largest_difference(bow.angles, measure_angles(mesh, bow_beam(bow)))));
        if (cells == 20.0 && feasible % 8 == 0) {
          const MeshCheck check = check_mesh(mesh);
          CHECK(check.reason() == "");
          CHECK(check.max_warp < 0.02);
          CHECK(check.max_bow_aspect < 15.0);
        }
      }
    }
    CHECK(feasible == 40);
    CHECK(worst < 0.02);
  }
}

TEST_CASE("g1, g2: the waterline of the mesh widens, and is convex, where the margins say so") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    std::mt19937 random(200u + static_cast<unsigned>(family));
    int widens = 0, turns = 0, convex = 0, hollow = 0;
    for (int k = 0; k < 60; ++k) {
      BowParameters bow = random_bow(family, random);
      bow.Lf *= k % 2 ? 1.0 : 0.6;  // some too short
      bow.panel = bow.B / 40.0;
      const BowFeasibility f = check_feasibility(bow);
      if (value(f, "g6") < 0.0) continue;
      const std::vector<double> slope = slopes(waterline_row(bow_mesh(bow)));
      const double step = 4.0 / bow_beam(bow);  // of g [m] to a slope
      const double g1 = value(f, "g1") * step * (family_form(family).monotone ? 1.0 : -1.0);
      const double g2 = std::min(value(f, "g2") * step, value(f, "g2"));
      if (std::abs(g1) > 0.3) {
        CHECK((*std::min_element(slope.begin(), slope.end()) > 0.0) == (g1 > 0.0));
        ++(g1 > 0.0 ? widens : turns);
      }
      if (std::abs(g2) > 0.1) {
        CHECK((largest_decrease(slope) < 1e-6) ==
              (g2 > 0.0));  // rounding of differences lowers a straight slope
        ++(g2 > 0.0 ? convex : hollow);
      }
    }
    CHECK(widens + turns > 20);
    CHECK(convex + hollow > 10);
  }
}

TEST_CASE("g5: the shell of the mesh ends where the margin says") {
  for (const BowFamily family : all_families()) {
    CAPTURE(family_form(family).key);
    std::mt19937 random(300u + static_cast<unsigned>(family));
    int feasible = 0;
    for (int tried = 0; feasible < 10 && tried < 10000; ++tried) {
      BowParameters bow = random_bow(family, random);
      bow.panel = bow.B / 40.0;
      const BowFeasibility f = check_feasibility(bow);
      if (!f.feasible) continue;
      ++feasible;
      const QuadMesh mesh = bow_mesh(bow);
      const double end = aft_end(mesh, Patch::bow) + reamer_step(bow);
      CHECK(bow.L / 2.0 - end ==
            Approx(value(f, "g5")).margin(0.01 * bow.B));  // found 0.0005: panels of the aft end
      if (reamer_step(bow) > 0.0) CHECK(aft_end(mesh, Patch::reamer) == Approx(end));
    }
    CHECK(feasible == 10);
  }
}

TEST_CASE("g7 of chines: the waterline of the mesh turns by what the margin says") {
  std::mt19937 random(400);
  int creased = 0;
  for (int k = 0; k < 60; ++k) {
    BowParameters bow = random_bow(BowFamily::semi_spoon_chines, random);
    bow.panel = bow.B / 100.0;
    const BowFeasibility f = check_feasibility(bow);
    if (!f.feasible) continue;
    ++creased;
    const Row row = waterline_row(bow_mesh(bow));
    const std::vector<double> slope = slopes(row);
    std::size_t at = 0;
    while (row[at].along < bow.chine * bow.B / 2.0 - 1e-9) ++at;
    const double turn = degrees(std::atan2(1.0, slope[at - 1]) - std::atan2(1.0, slope[at]));
    CHECK(turn == Approx(3.0 + degrees(value(f, "g7"))).margin(1.5));  // the fairing starts in the same panel
  }
  CHECK(creased > 10);
}
