#include "study/plan/constraints.h"

#include <catch2/catch.hpp>

#include "base/errors.h"
#include "base/json_fields.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

// The fake's load is 1.45 MN at 25 deg, 1.27 at 22, 2.27 at 30.
StudySpec constrained(const std::string& constraints) {
  return fake_study(R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [22, 30]}}},
    "constraints": )" +
                    constraints + "}");
}

StudyOutcome run(const StudySpec& spec, const std::string& directory, RecordingObserver& observer) {
  return run_study(Communicator::serial(), spec, fake_settings(directory), observer);
}

std::string pointer_of_mistake(const std::string& patch) {
  try {
    fake_study(patch);
  } catch (const InputError& error) {
    return error.mistakes().at(0).pointer;
  }
  return "";
}

}  // namespace

TEST_CASE("a design that breaks a constraint is infeasible, and another bound costs no evaluation") {
  const TemporaryDirectory directory;
  RecordingObserver first, wider, none;
  const std::string load = R"([{"at": "/metrics/full_scale/mean_load_N", "max": )";
  const StudyOutcome tight = run(constrained(load + "1.4e6}]"), directory / "s", first);
  CHECK(tight.ok == 1);
  CHECK(tight.infeasible == 2);
  CHECK(tight.best == "d001");
  CHECK_THAT(first.finished[0].reason,
             Catch::Contains("/metrics/full_scale/mean_load_N is 1.57e+06, more than"));
  const StudyOutcome loose = run(constrained(load + "2e6}]"), directory / "s", wider);
  CHECK(wider.started.empty());
  CHECK(loose.ok == 2);
  const Store store = Store::open_read_only(directory / "s/results.sqlite");
  CHECK(store.find_name("d002")->result.at("constraint") == "/metrics/full_scale/mean_load_N");
  CHECK_FALSE(store.find_name("baseline")->result.contains("constraint"));
  CHECK(run(fake_study(), directory / "s", none).ok == 1);
  CHECK(none.started.empty());
}

TEST_CASE("an optimum keeps to a constraint on a result") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudyOutcome outcome =
      run(fake_study(R"({"method": {"type": "optimise", "max_evaluations": 40, "variables": {
            "/bow/stem_deg": {"min": 15, "max": 34}}},
            "constraints": [{"at": "/metrics/full_scale/mean_load_N", "min": 1.4e6}]})"),
          directory / "s", observer);
  const Store store = Store::open_read_only(directory / "s/results.sqlite");
  const double best = number_at(store.find_name(outcome.best)->result, "/metrics/full_scale/mean_load_N");
  CHECK(best >= 1.4e6);
  CHECK(best < 1.41e6);  // the bound is where the load is 1.4 MN; the search stops within 1 % of the range
}

TEST_CASE("a number that a stored result lacks") {
  Evaluation e;
  e.status = EvaluationStatus::ok;
  e.result = {{"hull", {{"margins", {{"g1", 3.0}}}}}};
  apply_constraints({{"/hydrostatics/displacement_kg", 1.0, 2.0}}, e);
  CHECK(e.status == EvaluationStatus::failed);
  CHECK(lacks_a_number(e));
  apply_constraints({{"/hull/margins/g1", 2.0, 4.0}}, e);
  CHECK(e.status == EvaluationStatus::ok);
  CHECK_FALSE(lacks_a_number(e));
}

TEST_CASE("hydrostatics of a formula study are of its mesh, and what is stored without them is completed") {
  const std::string formula = R"("evaluators": ["lindqvist"], "ranking": {"by": "lindqvist_breaking"})";
  const TemporaryDirectory directory;
  RunSettings settings;
  settings.directory = directory / "s";
  settings.launcher = Launcher::embedded;
  RecordingObserver plain, asked;
  run_study(Communicator::serial(), fake_study("{" + formula + "}"), settings, plain);
  const StudySpec spec = fake_study(
      "{" + formula + R"(, "constraints": [{"at": "/hydrostatics/displacement_kg", "min": 1e7}]})");
  CHECK(run_study(Communicator::serial(), spec, settings, asked).ok == 1);
  CHECK(asked.started == std::vector<std::string>{"baseline"});
  const Json& h = asked.finished.at(0).result.at("hydrostatics");
  CHECK(h.at("draft_m").get<double>() == Approx(8.0));
  CHECK(h.at("displacement_kg").get<double>() == Approx(1025.0 * h.at("volume_m3").get<double>()));
  CHECK(h.at("block_coefficient").get<double>() > 0.7);
  CHECK(h.at("block_coefficient").get<double>() < 1.0);
}

TEST_CASE("mistakes in constraints are told by pointer") {
  CHECK(
      pointer_of_mistake(R"({"constraints": [{"at": "/hydrostatics/displacement_kg", "min": 1}]})").empty());
  for (const char* none : {"/lindqvist/braking_N", "/lindqvist/reason", "/hydrostatics/displacement",
                           "/hull/margins/g99", "/metrics/full_scale/mean_load"})
    CHECK(pointer_of_mistake(std::string(R"({"constraints": [{"max": 1, "at": ")") + none + R"("}]})") ==
          "/constraints/0/at");
  CHECK(pointer_of_mistake(R"({"constraints": [{"at": "/bow/stem_deg", "min": 1}]})") == "/constraints/0/at");
  CHECK(pointer_of_mistake(R"({"constraints": [{"at": "/cycle/mean_load_N", "min": 1}]})") ==
        "/constraints/0/at");
  CHECK(pointer_of_mistake(R"({"constraints": [{"at": "/hull/margins/g1"}]})") == "/constraints/0");
  CHECK(pointer_of_mistake(R"({"constraints": [{"at": "/hull/margins/g1", "min": 2, "max": 1}]})") ==
        "/constraints/0/min");
  CHECK(pointer_of_mistake(R"({"constraints": [{"at": "/hull/margins/g1", "mx": 2, "min": 1}]})") ==
        "/constraints/0/mx");
  CHECK(pointer_of_mistake(R"({"constraints": {}})") == "/constraints");
}
