// The load is the hull's, not its mesh's: triangles or quads, few panels or many.
#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/triangles.h"
#include "hullgen/bow/bow_mesh.h"
#include "hullgen/bow/family.h"
#include "solver/run/simulation.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

constexpr double beam = 0.9;  //!< of the model [m]

QuadMesh model_bow(BowFamily family, double panels_per_beam) {
  BowParameters bow = preset_bow(family);
  bow.panel = bow.B / panels_per_beam;
  return scaled(bow_mesh(bow), beam / bow.B);
}

QuadMesh in_triangles(const QuadMesh& mesh) {
  QuadMesh result;
  result.points = mesh.points;
  for (const auto& t : triangles(mesh)) result.quads.push_back({t[0], t[1], t[2], t[2]});
  result.patch.assign(result.quads.size(), Patch::other);
  return result;
}

// Frictionless, in double precision.
Scenario run(double advance) {
  Scenario s = tiny_run(1.2, advance);
  s.sheet.width = 1.3;
  s.V = 1.0;
  s.numerics.friction = 0.0;
  s.numerics.precision = Precision::fp64;
  return s;
}

// Of ice that does not break: the same push gives the same load, without the chaos of cracks.
Scenario unbroken(double advance) {
  Scenario s = run(advance);
  s.ice.K_I = 0.0;
  s.ice.s0 = 0.049;
  return s;
}

std::vector<HistoryRow> record(const QuadMesh& hull, const Scenario& s) {
  const RunResult result = simulate(Communicator::serial(), hull, s, {});
  REQUIRE(result.status == RunStatus::ok);
  return result.history.rows;
}

double mean_load(const std::vector<HistoryRow>& rows) {
  double sum = 0.0;
  for (const HistoryRow& row : rows) sum -= row.F[0];
  return sum / static_cast<double>(rows.size());
}

double largest_load(const std::vector<HistoryRow>& rows) {
  double load = 0.0;
  for (const HistoryRow& row : rows) load = std::max(load, std::abs(row.F[0]));
  return load;
}

}  // namespace

TEST_CASE("a hull in quads and in triangles has the same load record") {
  const QuadMesh quads = model_bow(BowFamily::concave, 10.0), faces = in_triangles(quads);
  REQUIRE(faces.quads.size() > 1.8 * quads.quads.size());
  const auto a = record(quads, run(0.12)), b = record(faces, run(0.12));
  REQUIRE(a.size() == b.size());
  CHECK(a.back().broken_bonds > 0);
  CHECK(a.back().broken_bonds == b.back().broken_bonds);
  const double scale = largest_load(a);
  double difference = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(a[k].F[c] - b[k].F[c]));
  INFO(difference / scale << " of the largest load, " << a.back().broken_bonds << " bonds");
  CHECK(difference < 1e-9 * scale);  // a quad and its two triangles round their normals apart
}

// Against the finest mesh. Cracks branch differently after the first breaks, so their load is compared
// loosely.
TEST_CASE("the load does not depend on the size of the panels") {
  struct Compared {
    BowFamily family;
    Scenario scenario;
    double tolerance;
  };
  for (const Compared& c : {Compared{BowFamily::straight_parallel_buttocks, unbroken(0.08), 2e-3},
                            {BowFamily::thyssen_waas, unbroken(0.08), 2e-3},
                            {BowFamily::straight_parallel_buttocks, run(0.08), 0.05}}) {
    const double fine = mean_load(record(model_bow(c.family, 40.0), c.scenario));
    CHECK(fine > 1.0);
    for (const double n : {10.0, 20.0}) {
      const double off = mean_load(record(model_bow(c.family, n), c.scenario)) / fine - 1.0;
      INFO(family_form(c.family).key << ", panels of B/" << n << ": " << 100.0 * off << " % off " << fine
                                     << " N");
      CHECK(std::abs(off) < c.tolerance);
    }
  }
}
