// Studies whose designs an optimiser proposes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/fake_runs.h"

using namespace icebow;

TEST_CASE("the optimiser starts from the stored baseline and finds the best bow") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  StudySpec spec = fake_study(optimisation);
  spec.method.max_evaluations = 120;
  const StudyOutcome outcome = run(spec, fake_settings(directory / "s"), observer);
  CHECK(observer.planned.proposals == 119);
  const Ranking ranking =
      rank_designs(Store::open_read_only(directory / "s/results.sqlite").all(), "mean_load");
  REQUIRE(ranking.rows[0].evaluation.name == outcome.best);
  CHECK(ranking.rows[0].evaluation.parameters.at("/bow/stem_deg") ==
        Approx(20).margin(0.01));  // degrees; found 2e-5 after 120 points
  CHECK(ranking.rows[0].evaluation.parameters.at("/bow/waterline_deg") ==
        Approx(30).margin(0.01));         // likewise
  CHECK(observer.started.size() <= 120);  // the first of its points is the baseline
  int of_start = 0;
  for (const Evaluation& e : observer.finished) {
    of_start += e.parameters.at("/bow/stem_deg") == 25 && e.parameters.at("/bow/waterline_deg") == 22;
  }
  CHECK(of_start == 1);
}

TEST_CASE("an optimiser that starts beyond what is feasible comes back") {
  for (const std::string algorithm : {"cobyla", "sbplx"}) {
    CAPTURE(algorithm);
    const TemporaryDirectory directory;
    StudySpec spec =
        fake_study(R"({"bow": {"stem_deg": 45}, "method": {"type": "optimise", "max_evaluations": 60,
      "variables": {"/bow/stem_deg": {"min": 15, "max": 60}, "/bow/waterline_deg": {"min": 20, "max": 45}}}})");
    spec.method.algorithm = algorithm;
    const StudyOutcome outcome = run(spec, directory / "s");
    const auto best = Store::open_read_only(directory / "s/results.sqlite").find_name(outcome.best);
    REQUIRE(best);
    CHECK(best->status == EvaluationStatus::ok);
    CHECK(best->parameters.at("/bow/stem_deg") <= largest_fake_stem + 1e-9);
  }
}

TEST_CASE("an optimiser's start is one of its points, and costs nothing where it is the baseline") {
  CHECK(plan_study(fake_study(optimisation)).proposals == 29);  // the baseline is within the ranges
  CHECK(plan_study(
            fake_study(R"({"include_baseline": false, "method": {"type": "optimise", "max_evaluations": 30,
    "variables": {"/bow/stem_deg": {"min": 15, "max": 34}}}})"))
            .proposals == 30);
}

TEST_CASE("an optimiser with two objectives finds designs along the front, within its budget") {
  // The load is smallest at a stem of 20 deg, the margin g1 largest at 15: the front lies between.
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudySpec spec = fake_study(R"({
    "ranking": {"by": ["mean_load", {"by": "/hull/margins/g1", "best": "largest"}]},
    "method": {"type": "optimise", "max_evaluations": 60, "variables": {"/bow/stem_deg": {"min": 15, "max": 34}}}})");
  const StudyOutcome outcome =
      run_study(Communicator::serial(), spec, fake_settings(directory / "s"), observer);
  CHECK_THAT(outcome.notes.back(), Catch::Contains("the front was searched by"));
  CHECK(observer.finished.size() <= 60);
  std::vector<double> stems;
  for (const Evaluation& e : observer.finished) stems.push_back(e.parameters.at("/bow/stem_deg"));
  for (const double wanted : {15.0, 17.5, 20.0}) {
    CAPTURE(wanted);
    CHECK(
        std::any_of(stems.begin(), stems.end(), [&](double stem) { return std::fabs(stem - wanted) < 0.5; }));
  }
}

TEST_CASE("where the second objective agrees with the first it is said that there is no front") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudySpec spec = fake_study(R"({
    "ranking": {"by": ["mean_load", "lindqvist_breaking"]},
    "method": {"type": "optimise", "max_evaluations": 30, "variables": {"/bow/stem_deg": {"min": 15, "max": 34}}}})");
  const StudyOutcome outcome =
      run_study(Communicator::serial(), spec, fake_settings(directory / "s"), observer);
  CHECK_THAT(outcome.notes.back(), Catch::Contains("there is no front"));
}
