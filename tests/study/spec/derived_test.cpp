#include "study/spec/spec_derived.h"

#include <catch2/catch.hpp>

#include "base/errors.h"
#include "study/plan/design_space.h"
#include "tests/support/fake_study.h"

namespace icebow {
namespace {

Mistakes mistakes_of(const std::string& patch) {
  try {
    fake_study(patch);
  } catch (const InputError& error) {
    return error.mistakes();
  }
  return {};
}

}  // namespace

TEST_CASE("a derived number follows the design, its variables and other derived numbers") {
  const StudySpec spec = fake_study(R"({
    "derived": {"/bow/bow_length_m": "1.5 * bow.beam_m", "/bow/depth_m": "bow.draft_m + bow.bow_length_m / 6",
                "/bow/flare_deg": "atan(tan(bow.waterline_deg * deg) / tan(bow.stem_deg * deg)) / deg"},
    "designs": [{"name": "wide", "set": {"bow": {"beam_m": 24}}}],
    "method": {"type": "grid", "variables": {"/bow/beam_m": {"values": [20, 22]}}}})");
  CHECK(spec.baseline.bow.Lf == Approx(34.5));
  CHECK(spec.baseline.bow.D == Approx(8.0 + 34.5 / 6.0));
  CHECK(degrees(spec.baseline.bow.angles.flare) == Approx(40.905).epsilon(1e-4));  // by hand, to five digits
  const StudyPlan plan = plan_study(spec);
  REQUIRE(plan.designs.size() == 4);
  CHECK(plan.designs[1].design.given->bow.Lf == Approx(36.0));
  CHECK(plan.designs[2].design.given->bow.Lf == Approx(30.0));
  CHECK(plan.designs[3].design.given->bow.D == Approx(8.0 + 33.0 / 6.0));
}

TEST_CASE("a derived number may compare, and take functions of several numbers") {
  CHECK(fake_study(R"({"derived": {"/bow/bow_length_m":
      "bow.beam_m == 23 && bow.draft_m <= 8 ? max(32, 33, 31) : 30"}})")
            .baseline.bow.Lf == 33.0);
}

TEST_CASE("an expression that is none, a circle, and what is given twice are mistakes at their place") {
  const auto at_bow_length = [](const std::string& expression) {
    const Mistakes found = mistakes_of(R"({"derived": {"/bow/bow_length_m": ")" + expression + "\"}}");
    REQUIRE(found.size() == 1);
    CHECK(found[0].pointer == "/derived/~1bow~1bow_length_m");
    return found[0].message;
  };
  CHECK_THAT(at_bow_length("1.5 * "), Catch::Contains("no expression"));
  CHECK_THAT(at_bow_length("1.5 * bow.baem_m"), Catch::Contains("no number at /bow/baem_m"));
  CHECK_THAT(at_bow_length("bow.bow_length_m + 1"), Catch::Contains("depends on itself"));
  CHECK_THAT(at_bow_length("bow.beam_m / 0"), Catch::Contains("gives no number"));
  CHECK_THAT(at_bow_length("1,4 * bow.beam_m"), Catch::Contains("gives 2 numbers"));
  CHECK_THAT(at_bow_length("bow.beam_m = 30"), Catch::Contains("has a ="));
  CHECK(mistakes_of(R"({"derived": {"/bow/reamer_step_m": "1"}})").at(0).message.find("not in this file") !=
        std::string::npos);
  CHECK(mistakes_of(R"({"derived": {"/bow/family": "1"}})").size() == 1);
  CHECK(
      mistakes_of(
          R"({"derived": {"/bow/beam_m": "23"}, "designs": [{"name": "a", "set": {"bow": {"beam_m": 22}}}]})")
          .at(0)
          .pointer == "/designs/0/set/bow/beam_m");
  CHECK_THAT(mistakes_of(R"({"derived": {"/bow/beam_m": "23"},
               "method": {"type": "grid", "variables": {"/bow/beam_m": {"values": [20, 22]}}}})")
                 .at(0)
                 .message,
             Catch::Contains("vary what that depends on"));
  // What the expression gives keeps to the key's range.
  CHECK(mistakes_of(R"({"derived": {"/bow/stem_deg": "90"}})").at(0).pointer == "/bow/stem_deg");
}

}  // namespace icebow
