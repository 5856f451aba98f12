// Designs judged over several conditions.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "base/json_fields.h"
#include "formula/lindqvist.h"
#include "study/evaluate/evaluate.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/scenario_result.h"
#include "study/plan/design_space.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

constexpr const char* thin_and_thick = R"({"evaluators": ["lindqvist"], "scenarios": [
  {"name": "thin", "weight": 3, "set": {"ice": {"thickness_m": 0.5}}},
  {"name": "thick", "set": {"ice": {"thickness_m": 1.5}, "operation": {"speed_kn": 2}}}]})";

Evaluation evaluated(const StudySpec& spec) {
  return evaluate(Communicator::serial(), baseline_of(spec), {});
}

double formula(double thickness, double speed_kn) {
  Json document = fake_document();
  document["ice"]["thickness_m"] = thickness, document["operation"]["speed_kn"] = speed_kn;
  return lindqvist(lindqvist_inputs(read_study(document, "t").baseline)).total;
}

std::vector<std::string> pointers(const std::string& patch) {
  std::vector<std::string> list;
  try {
    fake_study(patch);
  } catch (const InputError& error) {
    for (const Mistake& m : error.mistakes()) list.push_back(m.pointer);
  }
  return list;
}

std::vector<std::string> pointers_of_scenario(const std::string& scenario) {
  return pointers(R"({"evaluators": ["lindqvist"], "scenarios": [)" + scenario + "]}");
}

}  // namespace

TEST_CASE("a design's load over scenarios is their weighted mean, or that of the worst") {
  const Evaluation mean = evaluated(fake_study(thin_and_thick));
  REQUIRE(mean.status == EvaluationStatus::ok);
  const double thin = formula(0.5, 4), thick = formula(1.5, 2);
  CHECK(number_at(mean.result, "/lindqvist/total_N") == Approx(0.75 * thin + 0.25 * thick));
  CHECK(number_at(mean.result, "/scenarios/1/lindqvist/total_N") == Approx(thick));
  CHECK(mean.result.at("scenarios").at(0).at("name") == "thin");
  Json worst = fake_document(thin_and_thick);
  worst["ranking"] = {{"over_scenarios", "worst"}};
  CHECK(number_at(evaluated(read_study(worst, "t")).result, "/lindqvist/total_N") ==
        Approx(std::max(thin, thick)));
}

TEST_CASE("half widths are of independent scenarios; a largest load stays the largest") {
  const auto result = [](double load, double ci95, double max) {
    return Json{{"metrics",
                 {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", ci95}, {"max_load_N", max}}},
                  {"samples", 7}}}};
  };
  const std::vector<ScenarioResult> two = {{"a", 1.0, result(10, 3, 50)}, {"b", 3.0, result(20, 4, 40)}};
  const Json mean = combined(two, false).at("metrics").at("full_scale"),
             worst = combined(two, true).at("metrics").at("full_scale");
  CHECK(mean.at("mean_load_N").get<double>() == Approx(17.5));
  CHECK(mean.at("mean_load_ci95_N").get<double>() == Approx(std::hypot(0.25 * 3, 0.75 * 4)));
  CHECK(mean.at("max_load_N") == 50.0);
  CHECK(worst.at("mean_load_N") == 20.0);
  CHECK(worst.at("mean_load_ci95_N") == 4.0);
  std::vector<ScenarioResult> one_missing = two;
  one_missing[1].result["metrics"]["full_scale"]["mean_load_N"] = nullptr;
  CHECK(combined(one_missing, false).at("metrics").at("full_scale").at("mean_load_N").is_null());
}

TEST_CASE("loads whose names are no pointers are means too") {
  const auto printed = [](double load) { return Json{{"programs", {{"yard", {{"a~b/c_N", load}}}}}}; };
  const Json mean = combined({{"a", 1.0, printed(10)}, {"b", 3.0, printed(20)}}, false);
  CHECK(mean.at("programs").at("yard").at("a~b/c_N") == 17.5);
}

TEST_CASE("samples behind a mean over scenarios are Welch's; those of the worst are its own") {
  const auto result = [](double load, double ci95, double samples) {
    return Json{{"metrics",
                 {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", ci95}}},
                  {"effective_samples", samples}}}};
  };
  const auto samples = [](const std::vector<ScenarioResult>& two, bool worst) {
    return number_at(combined(two, worst), "/metrics/effective_samples");
  };
  // Alike: twice the degrees of freedom of one.
  CHECK(samples({{"a", 1.0, result(10, 3, 16)}, {"b", 1.0, result(10, 3, 16)}}, false) == Approx(1 + 2 * 15));
  // One is all but exact: those of the other.
  CHECK(samples({{"a", 1.0, result(10, 3, 16)}, {"b", 1.0, result(10, 1e-6, 9)}}, false) == Approx(16));
  CHECK(samples({{"a", 1.0, result(10, 3, 16)}, {"b", 1.0, result(20, 4, 9)}}, true) == 9.0);
  CHECK(std::isnan(samples({{"a", 1.0, result(10, 3, 16)}, {"b", 1.0, result(20, NAN, 9)}}, false)));
}

TEST_CASE("the cycle is evaluated in each scenario") {
  Json document = fake_document(thin_and_thick);
  document["evaluators"] = {"cycle"};
  document["cycle"] = {{"voyages", 1}, {"voyage_m", 30}};
  const Evaluation e = evaluated(read_study(document, "t"));
  REQUIRE(e.status == EvaluationStatus::ok);
  const double thin = number_at(e.result, "/scenarios/0/cycle/mean_load_N"),
               thick = number_at(e.result, "/scenarios/1/cycle/mean_load_N");
  CHECK(thin < thick);
  CHECK(number_at(e.result, "/metrics/full_scale/mean_load_N") == Approx(0.75 * thin + 0.25 * thick));
  CHECK(number_at(e.result, "/cycle/mean_load_N") == Approx(0.75 * thin + 0.25 * thick));
}

TEST_CASE("a key holds the scenarios, and not the conditions that none of them has") {
  const auto key = [](const std::string& patch) {
    Json document = fake_document(thin_and_thick);
    document.merge_patch(Json::parse(patch));
    const StudySpec spec = read_study(document, "t");
    return evaluation_key(spec.baseline, {true, false, false});
  };
  CHECK(key("{}") == key(R"({"ice": {"thickness_m": 0.8}})"));  // set by both
  CHECK(key("{}") != key(R"({"ice": {"density_kg_m3": 880}})"));
  CHECK(key("{}") != key(R"({"ranking": {"over_scenarios": "worst"}})"));
  CHECK(key("{}") != key(R"({"scenarios": [{"name": "thin", "set": {"ice": {"thickness_m": 0.5}}}]})"));
  CHECK(key("{}") != key(R"({"bow": {"stem_deg": 24}})"));
}

TEST_CASE("mistakes in scenarios are told by pointer") {
  using List = std::vector<std::string>;
  CHECK(pointers(thin_and_thick).empty());
  CHECK(pointers_of_scenario(R"({"name": "a", "set": {"ice": {"thickness_m": 99}}})") ==
        List{"/scenarios/0/set/ice/thickness_m"});
  CHECK(pointers_of_scenario(R"({"name": "a", "set": {"bow": {"stem_deg": 20}}})") ==
        List{"/scenarios/0/set/bow"});
  CHECK(pointers_of_scenario(R"({"name": "a", "weight": 0, "set": {"ice": {"thickness_m": 1}}})") ==
        List{"/scenarios/0/weight"});
  CHECK(pointers_of_scenario(R"({"name": "a"})") == List{"/scenarios/0/set"});
  CHECK(pointers(R"({"evaluators": ["lindqvist"], "scenarios": []})") == List{"/scenarios"});
  constexpr const char* simulated = R"({"sheet": {"window_ahead_m": 40},
    "scenarios": [{"name": "a", "set": {"ice": {"thickness_m": 1}}}])";
  CHECK(pointers(std::string(simulated) + "}").empty());
  CHECK(pointers(std::string(simulated) + R"(, "decide": {}})") == List{"/decide"});
  Json environment = fake_document(thin_and_thick);
  environment["method"] = {
      {"type", "optimise"},
      {"variables",
       {{"/ice/thickness_m", {{"min", 0.5}, {"max", 1.5}}}, {"/bow/stem_deg", {{"min", 20}, {"max", 28}}}}}};
  try {
    read_study(environment, "t");
    FAIL("the ice was optimised");
  } catch (const InputError& error) {
    REQUIRE(error.mistakes().size() == 1);
    CHECK_THAT(error.mistakes()[0].message, Catch::Contains("/ice/thickness_m"));
  }
  CHECK(pointers(R"({"evaluators": ["lindqvist"], "ranking": {"over_scenarios": "mean"}})") ==
        List{"/ranking/over_scenarios"});
}
