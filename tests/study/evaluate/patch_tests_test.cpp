// The edge of a study's own ice pressed down by a plate, in the simulation.
#include "study/evaluate/patch_tests.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "cycle/breaking.h"
#include "study/evaluate/cycle_run.h"
#include "study/spec/spec_case.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

// Thick for its strips, so that the test is short.
Case coarse_case() {
  return read_case(
      fake_document(R"({"ice": {"model": "calibrated", "thickness_m": 1, "flexural_strength_kPa": 863,
                        "compressive_strength_MPa": 2.6, "elastic_modulus_MPa": 300},
                        "water": {"added_mass_m": 4, "drag": 1.2}, "solver": {"layers": 2}})"),
      "");
}

}  // namespace

TEST_CASE("a fast narrow edge breaks near the plate at a load of plate theory's size") {
  const Case c = coarse_case();
  const TemporaryDirectory cache;
  PatchPlan plan;
  plan.widths_h = {2.0}, plan.edge_speeds = {1.2};
  int told = 0;
  const auto count = [&](double, double) { ++told; };
  const PatchTable table = patch_table(Communicator::serial(), c, plan, cache / "tests", count);
  CHECK(told == 1);
  REQUIRE(table.tests.size() == 1);
  const cycle::PatchTest& t = table.tests[0];
  const cycle::Ice ice = cycle_ice(c);
  cycle::BreakingRule theory;
  theory.type = cycle::Breaking::plate;
  const double load = ice.sigma_f * ice.h * ice.h;
  // One-dimensional wedges against a lattice of two layers: half to double.
  const double expected = cycle::capacity(ice, theory, {2.0 * ice.h, 1.2, 1.2}).load / load;
  CHECK(t.capacity > 0.5 * expected);
  CHECK(t.capacity < 2.5 * expected);
  CHECK(t.length_l > 0.05);
  CHECK(t.length_l < 1.5);

  const PatchTable again = patch_table(Communicator::serial(), c, plan, cache / "tests", count);
  CHECK(told == 1);  // recalled
  CHECK(again.recalled);
  CHECK(again.tests[0].capacity == t.capacity);
}

TEST_CASE("the plan follows the ship's speed, and other rules need no tests") {
  Case c = coarse_case();
  CHECK(patch_plan(c).edge_speeds.size() == 3);
  CHECK(patch_plan(c).edge_speeds.back() == Approx(std::max(0.1, 0.6 * c.V)));
  c.cycle.rule.type = cycle::Breaking::plate;
  CHECK(cycle_rule(Communicator::serial(), c).table.empty());
}
