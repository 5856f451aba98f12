// Studies searched by expected improvement, with loads by a formula.
#include "study/run/learning_loop.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>

#include "study/plan/ranking.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

std::string search(int evaluations, const std::string& more = "") {
  return R"({"method": {"type": "optimise", "algorithm": "expected_improvement", "least_gain": 0, "prior": "none",
    "variables": {"/bow/stem_deg": {"min": 15, "max": 45}, "/bow/waterline_deg": {"min": 20, "max": 45}},
    "max_evaluations": )" +
         std::to_string(evaluations) + more + "}}";
}

StudyOutcome run(const StudySpec& spec, const RunSettings& settings) {
  RecordingObserver observer;
  return run_study(Communicator::serial(), spec, settings, observer);
}

Json ranking_of(const std::string& directory) {
  const Store store = Store::open_read_only(directory + "/results.sqlite");
  return to_json(rank_designs(store.all(), store.fact("rank_by")));
}

// Killed after `n` designs, in a process of its own.
void run_killed(const StudySpec& spec, const std::string& directory, int n) {
  const pid_t child = fork();
  if (child == 0) {
    RunSettings settings = fake_settings(directory);
    settings.evaluate = [n, count = 0](const Communicator& comm, const Design& d,
                                       const EvaluateOptions& o) mutable {
      if (count++ == n) kill(getpid(), SIGKILL);
      return fake_evaluate(comm, d, o);
    };
    run(spec, settings);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("a search by expected improvement finds the bow, and asks for no impossible one") {
  const TemporaryDirectory directory;
  const StudyOutcome outcome = run(fake_study(search(20)), fake_settings(directory / "s"));
  CHECK(outcome.ok == 20);
  CHECK(outcome.infeasible == 0);  // a stem of 35 to 45 deg is
  const Json ranking = ranking_of(directory / "s");
  const Json& best = ranking.at("designs").at(0).at("parameters");
  CHECK(best.at("/bow/stem_deg").get<double>() == Approx(20).margin(0.6));       // 0.4 % of the load
  CHECK(best.at("/bow/waterline_deg").get<double>() == Approx(30).margin(0.9));  // 0.4 % of the load
  REQUIRE(outcome.notes.size() == 2);
  CHECK_THAT(outcome.notes[0], Catch::Contains("after 20 points, 6 of them the initial design"));
  CHECK_THAT(outcome.notes[1], Catch::Contains("the lowest is d0") && Catch::Contains("1000 kN"));
}

TEST_CASE("a search that was killed, or is given more points, ends as one that was not") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(search(14, R"(, "batch": 2)"));
  run(spec, fake_settings(directory / "whole"));
  for (const int n : {3, 4, 2}) run_killed(spec, directory / "killed", n);
  run(spec, fake_settings(directory / "killed"));
  CHECK(ranking_of(directory / "killed") == ranking_of(directory / "whole"));
  run(fake_study(search(8, R"(, "batch": 2)")), fake_settings(directory / "longer"));
  const StudyOutcome longer = run(spec, fake_settings(directory / "longer"));
  CHECK(longer.recalled == 8);
  CHECK(ranking_of(directory / "longer") == ranking_of(directory / "whole"));
}

TEST_CASE("designs that were paid for before begin a search") {
  const TemporaryDirectory directory;
  const StudySpec sweep = fake_study(R"({"method": {"type": "latin_hypercube", "samples": 10,
    "variables": {"/bow/stem_deg": {"min": 15, "max": 34}, "/bow/waterline_deg": {"min": 20, "max": 45}}}})");
  run(sweep, fake_settings(directory / "s"));
  const StudyOutcome outcome = run(fake_study(search(8)), fake_settings(directory / "s"));
  CHECK(std::any_of(outcome.notes.begin(), outcome.notes.end(), [](const std::string& note) {
    return note.find("after 8 points, 1 of them the initial design, and 10 that were paid for before") !=
           std::string::npos;
  }));
  // Of another ice they are of no use.
  StudySpec other = fake_study(R"({"ice": {"thickness_m": 1.2}})");
  Json document = other.document;
  document.merge_patch(Json::parse(search(8)));
  const StudyOutcome anew = run(read_study(document, "fake.json"), fake_settings(directory / "s"));
  CHECK(std::none_of(anew.notes.begin(), anew.notes.end(),
                     [](const std::string& note) { return note.find("paid for") != std::string::npos; }));
}

TEST_CASE("a cheaper response is evaluated once, beside the study's designs, and taken in") {
  const TemporaryDirectory directory;
  int cheap = 0;
  RunSettings settings = fake_settings(directory / "s");
  settings.evaluate = [&](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = fake_evaluate(comm, d, o);
    e.result["lindqvist"]["total_N"] = e.result["lindqvist"]["breaking_N"];
    cheap += d.name == "cheap";
    return e;
  };
  Json document = fake_study(search(9)).document;
  document["method"]["prior"] = "lindqvist";
  const StudySpec spec = read_study(document, "fake.json");
  const StudyOutcome outcome = run(spec, settings);
  CHECK(cheap == 48);
  CHECK(outcome.ok == 9);
  CHECK_THAT(outcome.notes.back(), Catch::Contains("of the formula's load"));  // half of it, exactly
  run(spec, settings);
  CHECK(cheap == 48);
}

TEST_CASE("a study in which too many designs fail ends, and goes on by the same command") {
  const TemporaryDirectory directory;
  StudySpec spec = fake_study(R"({"execution": {"stop_at_failure_rate": 0.4}, "method": {"type": "grid",
    "variables": {"/bow/waterline_deg": {"min": 20, "max": 30, "levels": 12}}}})");
  RunSettings settings = fake_settings(directory / "s");
  int evaluated = 0;
  settings.evaluate = [&](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = fake_evaluate(comm, d, o);
    if (++evaluated % 2 == 0) e.status = EvaluationStatus::failed, e.reason = "no licence";
    return e;
  };
  CHECK_THROWS_WITH(run(spec, settings),
                    Catch::Contains("3 of 6 designs failed") && Catch::Contains("no licence"));
  CHECK(evaluated == 6);
  CHECK(Store::open_read_only(directory / "s/results.sqlite").fact("state") == "interrupted");
  settings.evaluate = fake_evaluate;
  settings.retry_failed = true;
  CHECK(run(spec, settings).failed == 0);
}
