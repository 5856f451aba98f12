// One study by groups of ranks, each with a design of its own.
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <thread>

#include "study/plan/ranking.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"
#include "tests/support/main.h"

using namespace icebow;

namespace {

constexpr const char* grid = R"({"execution": {"designs_at_once": 8}, "method": {"type": "grid",
  "variables": {"/bow/stem_deg": {"values": [20, 22, 24, 26, 28, 30, 40]}}}})";

StudySpec study() {
  StudySpec spec = fake_study(grid);
  spec.execution.ranks_per_design = test_world().size() > 4 ? 2 : 1;  // 6 ranks: 2 groups of 2, one left over
  return spec;
}

// Collective over the group, as the real one is; its ranks agree on a number that all of them made.
Evaluation evaluate_by_group(const Communicator& comm, const Design& d, const EvaluateOptions& o) {
  Evaluation e = fake_evaluate(comm, d, o);
  std::int64_t ranks = 1;
  comm.sum(&ranks, 1);
  e.result["ranks"] = ranks;
  return e;
}

RunSettings settings_in(const std::string& directory) {
  RunSettings settings = fake_settings(directory);
  settings.evaluate = evaluate_by_group;
  return settings;
}

std::string shared(const TemporaryDirectory& own, const std::string& name) {
  return test_world().broadcast(own / name);
}

Json ranking_of(const std::string& directory) {
  const Store store = Store::open_read_only(directory + "/results.sqlite");
  return to_json(rank_designs(store.all(), store.fact("rank_by")));
}

}  // namespace

TEST_CASE("groups evaluate designs side by side, with the results of all ranks together") {
  const TemporaryDirectory own;
  const std::string grouped = shared(own, "grouped"), together = shared(own, "together");
  RecordingObserver observer, other;
  const StudyOutcome outcome = run_study(test_world(), study(), settings_in(grouped), observer);
  CHECK(outcome.ok == 7);
  CHECK(outcome.infeasible == 1);
  CHECK(outcome.best == "d001");
  StudySpec one = study();
  one.execution.designs_at_once = 1;
  run_study(test_world(), one, settings_in(together), other);
  if (test_world().is_root()) {
    CHECK(ranking_of(grouped) == ranking_of(together));
    CHECK(observer.finished.size() == 8);
    CHECK_FALSE(observer.progress.empty());
    const auto best = Store::open_read_only(grouped + "/results.sqlite").find_name("d001");
    REQUIRE(best);
    CHECK(best->result.at("ranks") == study().execution.ranks_per_design);
  }
  test_world().barrier();
  RecordingObserver again;
  CHECK(run_study(test_world(), study(), settings_in(grouped), again).recalled == 8);
}

TEST_CASE("an interrupt stops every group, and the same study goes on") {
  const TemporaryDirectory own;
  const std::string directory = shared(own, "s");
  RunSettings settings = settings_in(directory);
  RecordingObserver observer, rest;
  settings.stop = [&] { return !observer.finished.empty(); };
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = evaluate_by_group(comm, d, o);
    bool stop = false;
    for (int moment = 0; d.name != "baseline" && moment < 1000 && !stop; ++moment) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      stop = comm.any(o.stop && o.stop());
    }
    if (stop) e.status = EvaluationStatus::running;
    return e;
  };
  const StudyOutcome cut = run_study(test_world(), study(), settings, observer);
  CHECK(cut.interrupted);
  const StudyOutcome whole = run_study(test_world(), study(), settings_in(directory), rest);
  CHECK_FALSE(whole.interrupted);
  CHECK(whole.ok == 7);
  CHECK(whole.recalled >= 1);
}

TEST_CASE("the time limit stops one group; the others go on") {
  const TemporaryDirectory own;
  StudySpec spec = study();
  spec.execution.time_limit_s = 0.3;
  RunSettings settings = settings_in(shared(own, "s"));
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = evaluate_by_group(comm, d, o);
    bool stop = false;
    for (int moment = 0; d.name == "d003" && moment < 1000 && !stop; ++moment) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      stop = comm.any(o.stop && o.stop());
    }
    if (stop) e.status = EvaluationStatus::running;
    return e;
  };
  RecordingObserver observer;
  const StudyOutcome outcome = run_study(test_world(), spec, settings, observer);
  CHECK(outcome.failed == 1);
  CHECK(outcome.ok == 6);
}

TEST_CASE("an error in one group, or of the driver alone, is everybody's and nobody hangs") {
  const TemporaryDirectory own;
  RunSettings settings = settings_in(shared(own, "s"));
  RecordingObserver observer;
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) -> Evaluation {
    if (d.name == "d002" && comm.rank() == comm.size() - 1)
      throw std::runtime_error("this rank has a problem");
    return fake_evaluate(comm, d, o);  // no collective that the other would miss
  };
  CHECK_THROWS_AS(run_study(test_world(), study(), settings, observer), RuntimeError);
  settings.directory = "/proc/no/such/place";
  settings.evaluate = evaluate_by_group;
  CHECK_THROWS_AS(run_study(test_world(), study(), settings, observer), RuntimeError);
  StudySpec large = study();
  large.execution.ranks_per_design = 64;
  CHECK_THROWS_AS(run_study(test_world(), large, settings, observer), InputError);
}
