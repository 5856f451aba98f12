#include "study/plan/design_space.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

std::vector<std::string> names(const StudyPlan& plan) {
  std::vector<std::string> list;
  for (const PlannedDesign& p : plan.designs) list.push_back(p.design.name);
  return list;
}

}  // namespace

TEST_CASE("baseline, named designs, then a grid in order; the same ship once") {
  const StudySpec spec = fake_study(R"({
    "designs": [{"name": "blunt", "set": {"bow": {"stem_deg": 30}}}, {"name": "again", "set": {}}],
    "method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [20, 25, 30]},
                                             "/bow/waterline_deg": {"min": 22, "max": 32, "levels": 2}}}})");
  const StudyPlan plan = plan_study(spec);
  CHECK(names(plan) == std::vector<std::string>{"baseline", "blunt", "d001", "d002", "d004", "d006"});
  CHECK(plan.notes == std::vector<std::string>{"again is the same as baseline: evaluated once",
                                               "d003 is the same as baseline: evaluated once",
                                               "d005 is the same as blunt: evaluated once"});
  const Design& last = plan.designs.back().design;
  CHECK(last.parameters.at("/bow/stem_deg") == 30);
  CHECK(last.parameters.at("/bow/waterline_deg") == 32);
  CHECK(last.document.at("bow").at("stem_deg") == 30);
  const Design& blunt = plan.designs[1].design;
  CHECK(blunt.parameters.at("/bow/stem_deg") == 30);
  CHECK(blunt.parameters.at("/bow/waterline_deg") == 22);
}

TEST_CASE("a baseline that is not wanted is left out") {
  const StudySpec spec = fake_study(
      R"({"include_baseline": false, "designs": [{"name": "one", "set": {"bow": {"stem_deg": 30}}}]})");
  CHECK(names(plan_study(spec)) == std::vector<std::string>{"one"});
}

TEST_CASE("a Latin hypercube fills the ranges and is its seed's") {
  const auto study = [](int seed) {
    StudySpec spec =
        fake_study(R"({"include_baseline": false, "method": {"type": "latin_hypercube", "samples": 8,
      "variables": {"/bow/stem_deg": {"min": 20, "max": 36}, "/bow/waterline_deg": {"min": 22, "max": 30}}}})");
    spec.method.seed = seed;
    return plan_study(spec);
  };
  const StudyPlan plan = study(1);
  REQUIRE(plan.designs.size() == 8);
  std::vector<int> hits(8, 0);
  for (const PlannedDesign& p : plan.designs) {
    ++hits.at(static_cast<std::size_t>((p.design.parameters.at("/bow/stem_deg") - 20) / 2));
  }
  CHECK(std::count(hits.begin(), hits.end(), 1) == 8);
  for (std::size_t i = 0; i < 8; ++i) CHECK(study(1).designs[i].key == plan.designs[i].key);
  CHECK(study(2).designs[0].key != plan.designs[0].key);
}

TEST_CASE("a point the reader rejects is planned with its mistake") {
  const StudySpec spec = fake_study(R"({"method": {"type": "optimise", "variables": {
    "/bow/draft_m": {"min": 6, "max": 12}, "/bow/depth_m": {"min": 10, "max": 16}}}})");
  const PlannedDesign sunk = design_at(spec, "d001", {11, 12});  // in the order of the pointers: depth, draft
  CHECK_THAT(sunk.design.mistake, Catch::Contains("/bow/d"));
  CHECK_FALSE(sunk.key.empty());
  CHECK(design_at(spec, "d001", {16, 6}).design.mistake.empty());
  CHECK(plan_study(spec).proposals == 59);
}

TEST_CASE("a value that went through a scaling is the file's again") {
  const StudySpec spec = fake_study(R"({"method": {"type": "optimise",
    "variables": {"/bow/stem_deg": {"min": 18.1, "max": 33.3}}}})");
  const double u = (25 - 18.1) / (33.3 - 18.1);
  const PlannedDesign start = design_at(spec, "d001", {18.1 + u * (33.3 - 18.1)});
  CHECK(start.key == plan_study(spec).designs[0].key);
  CHECK(start_point(spec) == std::vector<double>{25});
  CHECK(rounded(19.999999999999996) == 20);
  CHECK(rounded(0.1) == 0.1);
}

TEST_CASE(
    "infeasible points of a sample are replaced by feasible ones, counted, and more samples keep them") {
  const auto sampled = [](const std::string& type, int samples) {
    return fake_study(
        R"({"include_baseline": false, "method": {"type": ")" + type + R"(", "replace_infeasible": true,
      "samples": )" +
        std::to_string(samples) +
        R"(, "variables": {"/bow/stem_deg": {"min": 10, "max": 60}, "/bow/waterline_deg": {"min": 10, "max": 60}}}})");
  };
  for (const char* type : {"sobol", "halton", "latin_hypercube"}) {
    CAPTURE(type);
    const StudySpec spec = sampled(type, 16);
    StudySpec as_it_comes = spec;
    as_it_comes.method.replace_infeasible = false;
    const auto infeasible = [&](const StudyPlan& plan) {
      return std::count_if(plan.designs.begin(), plan.designs.end(), [&](const PlannedDesign& p) {
        const auto& x = p.design.parameters;
        return !is_feasible_point(spec, {x.at("/bow/stem_deg"), x.at("/bow/waterline_deg")});
      });
    };
    const auto before = infeasible(plan_study(as_it_comes));
    const StudyPlan plan = plan_study(spec);
    REQUIRE(before > 0);
    CHECK(plan.designs.size() == 16);
    CHECK(infeasible(plan) == 0);
    CHECK_THAT(plan.notes.back(), Catch::Contains(std::to_string(before) + " of 16 points were infeasible"));
    const StudyPlan fewer = plan_study(sampled(type, 8));
    const StudyPlan other = type == std::string("latin_hypercube") ? plan_study(as_it_comes) : fewer;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < other.designs.size(); ++i) {
      const auto& x = other.designs[i].design.parameters;
      if (!is_feasible_point(spec, {x.at("/bow/stem_deg"), x.at("/bow/waterline_deg")})) continue;
      CHECK(plan.designs[i].design.parameters == x);
      ++kept;
    }
    CHECK(kept > 0);
  }
}

TEST_CASE("a family varies by its words, and whole numbers by their list, in a sample too") {
  const StudySpec spec = fake_study(R"({"method": {"type": "sobol", "samples": 12, "variables": {
      "/bow/family": {"values": ["concave", "straight_parallel_buttocks", "high_flare"]},
      "/cycle/voyages": {"values": [2, 3]}, "/bow/stem_deg": {"min": 20, "max": 28}}},
    "cycle": {"voyages": 3}})");
  std::map<std::string, int> families;
  std::map<double, int> voyages;
  for (const PlannedDesign& p : plan_study(spec).designs) {
    if (p.design.name == "baseline") continue;
    ++families[p.design.document.at("bow").at("family").get<std::string>()];
    ++voyages[p.design.parameters.at("/cycle/voyages")];
    Evaluation e;
    note_choices(spec, p.design, e);
    CHECK(e.result.at("choices").at("/bow/family") == p.design.document.at("bow").at("family"));
  }
  CHECK(families ==
        std::map<std::string, int>{{"concave", 4}, {"straight_parallel_buttocks", 4}, {"high_flare", 4}});
  CHECK(voyages[2] + voyages[3] == 12);
  CHECK(std::min(voyages[2], voyages[3]) >= 4);  // halves of the axis; twelve points of Sobol' are near even
  const StudySpec one = fake_study(R"({"method": {"type": "one_at_a_time", "variables": {
      "/bow/family": {"values": ["concave", "straight_parallel_buttocks"]},
      "/bow/stem_deg": {"values": [22]}}}})");
  const StudyPlan plan = plan_study(one);
  REQUIRE(plan.designs.size() == 3);
  CHECK(plan.designs[2].design.document.at("bow").at("family") ==
        "straight_parallel_buttocks");  // the file's own
}
