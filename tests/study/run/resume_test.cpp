// A study that is cut short, by whomever, and what it does with designs that failed.
#include <signal.h>

#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <csignal>

#include "study/run/failure.h"
#include "tests/support/fake_runs.h"

using namespace icebow;

namespace {

// An evaluator that ends its process, as a kill would, or a fault of its own, when it has finished `n`
// designs.
EvaluateFunction killed_after(int n, int signal) {
  return [n, signal, count = 0](const Communicator& comm, const Design& d, const EvaluateOptions& o) mutable {
    if (count++ == n) kill(getpid(), signal);
    return fake_evaluate(comm, d, o);
  };
}

// In a process of its own. True where it was killed.
bool killed(const StudySpec& spec, const std::string& directory, int after, int signal = SIGKILL) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(signal, SIG_DFL);  // Catch's handlers would report it
    RecordingObserver observer;
    RunSettings settings = fake_settings(directory);
    settings.evaluate = killed_after(after, signal);
    run(spec, settings, observer);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

}  // namespace

TEST_CASE("a killed study goes on where it was, to the same end as an uninterrupted one") {
  for (const char* study : {grid_3_by_2, optimisation}) {
    const StudySpec spec = fake_study(study);
    const TemporaryDirectory directory;
    RecordingObserver whole, resumed;
    const StudyOutcome expected = run(spec, fake_settings(directory / "whole"), whole);
    REQUIRE(killed(spec, directory / "cut", 3));
    REQUIRE(killed(spec, directory / "cut", 2));
    const StudyOutcome outcome = run(spec, fake_settings(directory / "cut"), resumed);
    CHECK(resumed.recalled.size() == 5);
    CHECK(resumed.started.size() == whole.started.size() - 5);
    CHECK(outcome.best == expected.best);
    CHECK(ranking_of(directory / "cut") == ranking_of(directory / "whole"));
  }
}

TEST_CASE("a design under way is not blamed for who kills the job, however often") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(grid_3_by_2);
  REQUIRE(killed(spec, directory / "s", 2));
  for (int k = 0; k < 4; ++k) REQUIRE(killed(spec, directory / "s", 0));
  const StudyOutcome outcome = run(spec, directory / "s");
  CHECK(outcome.failed == 0);
  CHECK(outcome.ok == 5);
}

TEST_CASE("a design that crashed the program twice is given up, and only it") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(grid_3_by_2);
  REQUIRE(killed(spec, directory / "s", 2, SIGSEGV));  // baseline, d001 done; d002 was running
  REQUIRE(killed(spec, directory / "s", 0, SIGKILL));  // d002 again, by somebody else: not counted
  {
    RunSettings interrupted = fake_settings(directory / "s");  // nor is the one crash again
    interrupted.stop = [] { return true; };
    RecordingObserver observer;
    CHECK(run(spec, interrupted, observer).interrupted);
  }
  REQUIRE(killed(spec, directory / "s", 0, SIGABRT));  // d002 once more
  {
    RunSettings settings = fake_settings(directory / "once");
    CHECK(killed(spec, directory / "once", 2, SIGSEGV));
    CHECK(killed(spec, directory / "once", 0, SIGFPE));
    settings.retry_failed = true;  // is heard in the very run that would give it up
    RecordingObserver at_once;
    CHECK(run(spec, settings, at_once).failed == 0);
    CHECK(at_once.started.front() == "d002");
  }
  RecordingObserver observer;
  const StudyOutcome outcome = run(spec, fake_settings(directory / "s"), observer);
  CHECK(outcome.failed == 1);
  CHECK(outcome.ok == 4);
  CHECK(observer.recalled == std::vector<std::string>{"baseline", "d001", "d002"});
  CHECK_THAT(observer.finished[2].reason, Catch::Contains("crashed twice") && Catch::Contains("signal 6"));
  RunSettings settings = fake_settings(directory / "s");
  settings.retry_failed = true;
  RecordingObserver again;
  CHECK(run(spec, settings, again).failed == 0);
  CHECK(again.started == std::vector<std::string>{"d002"});
}

TEST_CASE("an interrupted study says so, leaves nothing running, and goes on") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(grid_3_by_2);
  RecordingObserver observer, resumed;
  RunSettings settings = fake_settings(directory / "s");
  settings.stop = [&] { return observer.finished.size() >= 2 && observer.started.size() >= 3; };
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = fake_evaluate(comm, d, o);
    if (o.stop && o.stop()) e.status = EvaluationStatus::running;
    return e;
  };
  const StudyOutcome outcome = run(spec, settings, observer);
  CHECK(outcome.interrupted);
  CHECK(outcome.ok == 2);
  {
    const Store store = Store::open_read_only(directory / "s/results.sqlite");
    CHECK(store.everything().size() == 2);
    CHECK(store.fact("state") == "interrupted");
  }
  CHECK_FALSE(run(spec, fake_settings(directory / "s"), resumed).interrupted);
  CHECK(resumed.recalled.size() == 2);
}

TEST_CASE("failures are results: not tried again unless asked to") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(R"({"designs": [{"name": "bad", "set": {"bow": {"stem_deg": 21}}}]})");
  RunSettings settings = fake_settings(directory / "s");
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = fake_evaluate(comm, d, o);
    if (d.name == "bad") e.status = EvaluationStatus::failed, e.reason = "unstable";
    return e;
  };
  RecordingObserver first, second, third;
  CHECK(run(spec, settings, first).failed == 1);
  CHECK(run(spec, settings, second).failed == 1);
  CHECK(second.started.empty());
  settings.retry_failed = true;
  run(spec, settings, third);
  CHECK(third.started == std::vector<std::string>{"bad"});
}

TEST_CASE("a design is given its time and no more") {
  const TemporaryDirectory directory;
  RunSettings settings = fake_settings(directory / "s");
  settings.evaluate = [](const Communicator&, const Design& d, const EvaluateOptions& o) {
    while (!o.stop()) usleep(1000);
    Evaluation e;
    e.name = d.name;
    e.status = EvaluationStatus::running;
    return e;
  };
  RecordingObserver observer;
  const StudyOutcome outcome =
      run(fake_study(R"({"execution": {"time_limit_s": 0.05}})"), settings, observer);
  CHECK_FALSE(outcome.interrupted);
  CHECK(outcome.failed == 1);
  CHECK_THAT(observer.finished.at(0).reason, Catch::Contains("time limit"));
}

TEST_CASE("a fault of the machine ends the study, and the store is in order") {
  const TemporaryDirectory directory;
  RunSettings settings = fake_settings(directory / "s");
  settings.evaluate = [](const Communicator& comm, const Design& d, const EvaluateOptions& o) -> Evaluation {
    if (d.name == "d002") throw RuntimeError("disk full");
    return fake_evaluate(comm, d, o);
  };
  RecordingObserver observer;
  CHECK_THROWS_WITH(run(fake_study(grid_3_by_2), settings, observer), Catch::Contains("disk full"));
  CHECK(Store::open_read_only(directory / "s/results.sqlite").everything().size() == 2);
}

TEST_CASE("a design lost by a crash is tried again by another version of the program") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study();
  RunSettings settings = fake_settings(directory / "s");
  std::string version = "0.0.0";
  settings.evaluate = [&](const Communicator&, const Design& d, const EvaluateOptions&) {
    Evaluation e;
    e.name = d.name, e.status = EvaluationStatus::failed, e.reason = "the program was lost";
    e.result["failure"] = crash_failure();
    if (!version.empty()) e.result["failure"]["version"] = version;
    return e;
  };
  RecordingObserver first, second, third;
  run(spec, settings, first);
  version.clear();
  const StudyOutcome outcome = run(spec, settings, second);
  CHECK(second.started == std::vector<std::string>{"baseline"});
  CHECK_THAT(outcome.notes[0], Catch::Contains("baseline is tried again: it crashed version 0.0.0"));
  run(spec, settings, third);
  CHECK(third.started.empty());
}
