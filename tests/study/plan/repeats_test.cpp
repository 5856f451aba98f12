// Designs that are run more than once.
#include "study/plan/repeats.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/errors.h"
#include "study/evaluate/resolution_bias.h"
#include "study/plan/ranking.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

// Loads scatter with the seed alone: 0, 1, 2 above the formula's.
Evaluation scattered(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  Evaluation e = fake_evaluate(comm, design, options);
  if (e.status != EvaluationStatus::ok) return e;
  const double seed = design.document.value("/solver/seed"_json_pointer, 0.0);
  Json& loads = e.result["metrics"]["full_scale"];
  loads["mean_load_N"] = loads["mean_load_N"].get<double>() + 1e4 * seed;
  return e;
}

RunSettings settings_of(const std::string& directory, int& evaluated) {
  RunSettings settings;
  settings.directory = directory;
  settings.launcher = Launcher::embedded;
  settings.margins = fake_margins;
  settings.evaluate = [&evaluated](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    ++evaluated;
    return scattered(comm, d, o);
  };
  return settings;
}

Evaluation run(const std::string& name, double load, double ci95) {
  Evaluation e;
  e.name = name;
  e.status = EvaluationStatus::ok;
  e.result = {{"metrics", {{"full_scale", {{"mean_load_N", load}, {"mean_load_ci95_N", ci95}}}}},
              {"lindqvist", {{"breaking_N", 50.0}}},
              {"ship", {{"B_m", 20.0}}}};
  return e;
}

bool mention(const Ranking& ranking, const std::string& words) {
  for (const std::string& warning : ranking.warnings)
    if (warning.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("names of runs tell design and number") {
  CHECK(repeat_name("d001", 1) == "d001");
  CHECK(run_name(repeat_name("Thyssen-Waas", 12)).design == "Thyssen-Waas");
  CHECK(run_name(repeat_name("Thyssen-Waas", 12)).number == 12);
  CHECK(run_name("plain").number == 1);
}

TEST_CASE("repeats are planned beside their design, each with a seed and a key of its own") {
  const StudyPlan plan = plan_study(fake_study(R"({"repeats": 3, "solver": {"seed": 5}})"));
  REQUIRE(plan.designs.size() == 3);
  CHECK(plan.designs[0].design.name == "baseline");
  CHECK(plan.designs[2].design.name == "baseline#3");
  CHECK(plan.designs[0].design.document["solver"]["seed"] == 5);
  CHECK(plan.designs[2].design.document["solver"]["seed"] == 7);
  CHECK(plan.designs[0].key != plan.designs[1].key);
  // The first run is the one that a study without repeats makes.
  CHECK(plan_study(fake_study()).designs[0].key ==
        plan_study(fake_study(R"({"repeats": 2})")).designs[0].key);
}

TEST_CASE("repeats without a simulation are refused") {
  try {
    fake_study(R"({"repeats": 2, "evaluators": ["lindqvist"]})");
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("/repeats") != std::string::npos);
  }
}

TEST_CASE("a study runs every repeat once and ranks the mean of the runs") {
  const TemporaryDirectory folder;
  int evaluated = 0;
  StudyObserver observer;
  const StudySpec spec =
      fake_study(R"({"repeats": 3, "designs": [{"name": "best", "set": {"bow": {"stem_deg": 20,
    "waterline_deg": 30}}}, {"name": "steep", "set": {"bow": {"stem_deg": 40}}}]})");
  const StudyOutcome outcome =
      run_study(Communicator::serial(), spec, settings_of(folder / "out", evaluated), observer);
  CHECK(evaluated == 9);
  CHECK(outcome.best == "best");
  CHECK(outcome.infeasible == 1);  // a design, however often it was to be run
  const auto again =
      run_study(Communicator::serial(), spec, settings_of(folder / "out", evaluated), observer);
  CHECK(evaluated == 9);
  CHECK(again.recalled == 9);
}

TEST_CASE("an optimiser is told the mean of the runs") {
  const TemporaryDirectory folder;
  int evaluated = 0;
  StudyObserver observer;
  const StudySpec spec = fake_study(R"({"repeats": 2, "method": {"type": "optimise", "algorithm": "sbplx",
    "max_evaluations": 6, "variables": {"/bow/stem_deg": {"min": 18, "max": 30}}}})");
  run_study(Communicator::serial(), spec, settings_of(folder / "out", evaluated), observer);
  CHECK(evaluated >= 8);
  CHECK(evaluated % 2 == 0);
  CHECK(evaluated <= 12);
}

TEST_CASE("runs of a design make one row, with the interval of their scatter beside that of their series") {
  const Ranking r =
      rank_designs({run("a", 100, 3), run("b", 120, 3), run("a#3", 106, 3), run("a#2", 103, 3)}, "mean_load");
  REQUIRE(r.rows.size() == 2);
  const RankedDesign& a = r.rows[0];
  CHECK(a.evaluation.name == "a");
  CHECK(a.runs == 3);
  CHECK(a.mean_load == Approx(103.0));
  CHECK(a.ci95_series == Approx(std::sqrt(27.0) / 3.0));
  CHECK(a.ci95_repeats == Approx(4.302653 * 3.0 / std::sqrt(3.0)));  // Student's t of two degrees of freedom
  CHECK(a.mean_load_ci95 == a.ci95_repeats);
  CHECK(a.ratio == Approx(103.0 / 50.0));
  CHECK(r.rows[1].runs == 1);
  CHECK(r.rows[1].mean_load_ci95 == 3.0);
  CHECK(std::isnan(r.rows[1].ci95_repeats));
  CHECK_FALSE(a.tied_with_next);
}

TEST_CASE("a failed run is left out of its design's mean") {
  Evaluation failed = run("a", 1, 1);
  failed.status = EvaluationStatus::failed;
  const Ranking r = rank_designs({failed, run("a#2", 100, 3), run("a#3", 110, 3)}, "mean_load");
  REQUIRE(r.rows.size() == 1);
  CHECK(r.rows[0].evaluation.name == "a");  // not that of a run
  CHECK(r.rows[0].rank == 1);
  CHECK(r.rows[0].runs == 2);
  CHECK(r.rows[0].mean_load == Approx(105.0));
}

TEST_CASE("a ranking warns of differences below the intervals and below the resolution bias") {
  const Ranking unknown = rank_designs({run("a", 100, 9), run("b", 105, 9)}, "mean_load");
  CHECK(mention(unknown, "not told apart from the best design (Welch's test, p of 0.05 or more): b"));
  CHECK(mention(unknown, "resolution bias: not known for this spacing"));

  const auto with_bias = [](Evaluation e) {
    e.result["metrics"]["resolution_bias"] = {{"known", true}, {"relative", 0.1}, {"ci95", 0.02}};
    return e;
  };
  const Ranking known = rank_designs(
      {with_bias(run("a", 100, 1)), with_bias(run("b", 110, 1)), with_bias(run("c", 150, 1))}, "mean_load");
  CHECK_FALSE(mention(known, "not known"));
  CHECK_FALSE(mention(known, "intervals"));
  CHECK(mention(known, "resolution may change: b"));
  CHECK_FALSE(mention(known,
                      "c"
                      ", "));
  CHECK(rank_designs({run("a", 100, 9), run("b", 105, 9)}, "lindqvist_breaking").warnings.empty());
}

TEST_CASE("no lattice's resolution bias is known, and ice of a toughness has no limit to be far from") {
  Case c = fake_study().baseline;  // three layers
  c.ice.s0 = 0.0;
  c.numerics.contact = ContactRule::penalty;
  const auto sentence = [](const Case& one) {
    const Json bias = resolution_bias_json(one);
    CHECK(bias["known"] == false);
    CHECK(bias["relative"].is_null());
    return bias["sentence"].get<std::string>();
  };
  CHECK_THAT(
      sentence(c),
      Catch::Contains("not known for this spacing (3 layers, strength by toughness, contact penalty)") &&
          Catch::Contains("without a limit"));
  c.ice.s0 = 0.005;
  CHECK_THAT(sentence(c), Catch::Contains("strength by stretch") && !Catch::Contains("without a limit"));
}
