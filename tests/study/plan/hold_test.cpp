// Designs that keep a displacement.
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "hullgen/bow/bow_volume.h"
#include "study/evaluate/evaluation_key.h"
#include "study/plan/design_space.h"
#include "study/plan/feasible_box.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_hold.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

const std::string stems =
    R"("method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [22, 25, 28]},
                                                "/bow/flare_deg": {"values": [33, 40]}}})";

std::string mistakes_of_study(const std::string& patch) {
  try {
    fake_study(patch);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("every design displaces the same; the dimension that follows is told") {
  for (const std::string by : {"length", "beam", "draft"}) {
    INFO(by);
    const StudySpec spec = fake_study(R"({"hold": {"by": ")" + by + R"("}, )" + stems + "}");
    const double held = bow_displacement(fake_study().baseline.bow);
    CHECK(spec.document.at("hold").at("displacement_m3") == Approx(held).epsilon(1e-9));  // ten digits
    std::set<double> values;
    for (const PlannedDesign& p : plan_study(spec).designs) {
      REQUIRE(p.design.given);
      CHECK(bow_displacement(p.design.given->bow) ==
            Approx(held).epsilon(1e-8));  // ten digits of the dimension
      const double value = p.design.parameters.at("/bow/" + by + "_m");
      CHECK(p.design.document.at("bow").at(by + "_m") == value);
      values.insert(value);
    }
    CHECK(values.size() == 6);
    CHECK(spec.baseline.bow.L == Approx(147.2));  // the file's own bow is as it was
  }
}

TEST_CASE(
    "a displacement that is given moves the baseline too; the key is that of the same bow given directly") {
  const StudySpec spec = fake_study(R"({"hold": {"displacement_m3": 20000}, "designs": [
    {"name": "flat", "set": {"bow": {"stem_deg": 20}}}]})");
  CHECK(bow_displacement(spec.baseline.bow) == Approx(20000).epsilon(1e-8));  // ten digits
  const StudyPlan plan = plan_study(spec);
  REQUIRE(plan.designs.size() == 2);
  Json direct = fake_document();
  direct["bow"]["stem_deg"] = 20;
  direct["bow"]["length_m"] = plan.designs[1].design.parameters.at("/bow/length_m");
  CHECK(evaluation_key(read_case(direct, "direct"), plan.designs[1].design.asked) ==
        evaluation_key(*plan.designs[1].design.given, plan.designs[1].design.asked));
  CHECK(plan.notes == std::vector<std::string>{"the displacement is held at 20000 m3 by /bow/length_m"});
}

TEST_CASE("the section's unit and scale are kept") {
  const StudySpec spec =
      fake_study(R"({"scale": 20, "hold": {"displacement_m3": 20000}, "bow": {"scale": "model",
    "length_m": null, "length_cm": 736, "beam_m": 1.15, "draft_m": 0.4, "depth_m": 0.675, "bow_length_m": 1.625}})");
  CHECK(bow_displacement(spec.baseline.bow) == Approx(20000).epsilon(1e-8));  // ten digits
  CHECK(spec.document.at("bow").at("length_cm").get<double>() == Approx(100.0 * spec.baseline.bow.L / 20.0));
}

TEST_CASE(
    "what follows from a hold is no variable and no design's to say; impossible displacements are told") {
  CHECK_THAT(
      mistakes_of_study(R"({"hold": {}, "designs": [{"name": "a", "set": {"bow": {"length_m": 150}}}]})"),
      Catch::Contains("/designs/0/set/bow/length_m") && Catch::Contains("follows from the displacement"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {}, "method": {"type": "grid", "variables": {
                                   "/bow/length_m": {"values": [150]}}}})"),
             Catch::Contains("follows from the displacement"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {"displacement_m3": 100000, "by": "draft"}})"),
             Catch::Contains("/hold/displacement_m3") && Catch::Contains("no draft from"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {"displacement_m3": 200000}})"),
             Catch::Contains("no length from"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {"by": "depth"}})"), Catch::Contains("/hold/by"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {"displacement_t": 1000}})"), Catch::Contains("displacement_m3"));
  CHECK_THAT(mistakes_of_study(R"({"hold": {"by": "draft"}, "designs": [
               {"name": "short", "set": {"bow": {"length_m": 75}}}]})"),
             Catch::Contains("/designs/0/set/hold/displacement_m3"));
  CHECK(mistakes_of_study(R"({"hold": {"displacement_m3": 30000}})").empty());
}

TEST_CASE("check knows the range of what follows") {
  const FeasibleBox box =
      feasible_box(fake_study(R"({"hold": {}, "method": {"type": "latin_hypercube", "samples": 4,
    "variables": {"/bow/stem_deg": {"min": 22, "max": 28}}}})"));
  CHECK(box.held == "/bow/length_m");
  CHECK(box.held_lower < 147.2);
  CHECK(box.held_upper > 147.2);
  CHECK(box.held_upper - box.held_lower < 5.0);  // m: the stem moves a wedge of the forefoot
}
