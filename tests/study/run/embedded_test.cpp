// One study by all ranks of an MPI job together.
#include <catch2/catch.hpp>

#include "study/store/store.h"
#include "tests/support/fake_study.h"
#include "tests/support/main.h"

using namespace icebow;

namespace {

constexpr const char* grid = R"({"method": {"type": "grid",
  "variables": {"/bow/stem_deg": {"values": [20, 30, 40]}}}})";

// The root's temporary directory, known to all.
std::string shared(const TemporaryDirectory& own) {
  return test_world().broadcast(own / "s");
}

// Collective, as the real one is.
Evaluation evaluate_together(const Communicator& comm, const Design& d, const EvaluateOptions& o) {
  Evaluation e = fake_evaluate(comm, d, o);
  std::int64_t ranks = 1;
  comm.sum(&ranks, 1);
  e.result["ranks"] = ranks;
  return e;
}

}  // namespace

TEST_CASE("all ranks evaluate every design and agree on the outcome") {
  const TemporaryDirectory own;
  const std::string directory = shared(own);
  RunSettings settings = fake_settings(directory);
  settings.launcher = Launcher::automatic;
  settings.evaluate = evaluate_together;
  RecordingObserver observer;
  const StudyOutcome outcome = run_study(test_world(), fake_study(grid), settings, observer);
  CHECK(outcome.ok == 3);
  CHECK(outcome.infeasible == 1);
  CHECK(outcome.best == "d001");
  CHECK(observer.finished.size() == (test_world().is_root() ? 4U : 0U));
  if (test_world().is_root()) {
    const auto best = Store::open_read_only(directory + "/results.sqlite").find_name("d001");
    REQUIRE(best);
    CHECK(best->result.at("ranks") == test_world().size());
  }
  test_world().barrier();
  RecordingObserver again;
  CHECK(run_study(test_world(), fake_study(grid), settings, again).recalled == 4);
}

TEST_CASE("an optimisation by all ranks") {
  const TemporaryDirectory own;
  RunSettings settings = fake_settings(shared(own));
  settings.evaluate = evaluate_together;
  RecordingObserver observer;
  const StudySpec spec =
      fake_study(R"({"method": {"type": "optimise", "algorithm": "sbplx", "max_evaluations": 12,
    "tolerance": 0, "variables": {"/bow/stem_deg": {"min": 15, "max": 34}}}})");
  const StudyOutcome outcome = run_study(test_world(), spec, settings, observer);
  CHECK(outcome.ok > 6);  // a simplex on a line comes back to some of its 12 points
  CHECK(outcome.ok <= 12);
  REQUIRE(outcome.notes.size() == 1);
  CHECK_THAT(outcome.notes[0], Catch::Contains("12 points"));
}

TEST_CASE("an error of the root alone, or of one rank alone, is everybody's and nobody hangs") {
  const TemporaryDirectory own;
  RunSettings settings = fake_settings(shared(own));
  RecordingObserver observer;
  for (const int bad_rank : {0, test_world().size() - 1}) {
    settings.evaluate = [&](const Communicator& comm, const Design& d,
                            const EvaluateOptions& o) -> Evaluation {
      if (comm.rank() == bad_rank) throw std::runtime_error("this rank has a problem");
      return fake_evaluate(comm, d, o);
    };
    CHECK_THROWS_AS(run_study(test_world(), fake_study(grid), settings, observer), RuntimeError);
  }
  settings.directory = "/proc/no/such/place";
  settings.evaluate = evaluate_together;
  CHECK_THROWS_AS(run_study(test_world(), fake_study(grid), settings, observer), RuntimeError);
}
