// Studies whose designs run in processes of their own: study_child, with the fake evaluator.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <map>
#include <thread>

#include "base/child_process.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

RunSettings isolated(const std::string& directory) {
  RunSettings settings = fake_settings(directory);
  settings.launcher = Launcher::isolated;
  settings.program = STUDY_CHILD;
  settings.jobs = 2;
  return settings;
}

std::string designs(const std::vector<std::string>& names) {
  Json list = Json::array();
  double stem = 20;
  for (const std::string& name : names)
    list.push_back({{"name", name}, {"set", {{"bow", {{"stem_deg", stem++}}}}}});
  return Json{{"designs", list}}.dump();
}

const Evaluation& of(const RecordingObserver& observer, const std::string& name) {
  for (const Evaluation& e : observer.finished) {
    if (e.name == name) return e;
  }
  throw std::runtime_error("nothing was said of " + name);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("a crash costs the design that crashed, and says why") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudySpec spec = fake_study(designs({"good", "crash", "exit", "silent", "chatty"}));
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, isolated(directory / "s"), observer);
  CHECK(outcome.ok == 3);
  CHECK(outcome.failed == 3);
  CHECK(outcome.best == "good");
  CHECK_THAT(of(observer, "crash").reason, Catch::Contains("signal 6") && Catch::Contains("about to crash"));
  CHECK_THAT(of(observer, "exit").reason, Catch::Contains("exit code 1") && Catch::Contains("a message"));
  CHECK_THAT(of(observer, "silent").reason, Catch::Contains("without a result"));
  CHECK(observer.last_progress.advance == 0.5);
  CHECK_THAT(read_text_file(directory / "s/designs/crash/log.txt"), Catch::Contains("about to crash"));
  CHECK_THAT(read_text_file(directory / "s/designs/chatty/log.txt"), Catch::Contains("a library says hello"));
  CHECK(read_json_file(directory / "s/designs/crash/result.json").at("status") == "failed");
  CHECK(of(observer, "good").result.at("metrics").at("full_scale").at("mean_load_N") == fake_load(20, 22));
}

TEST_CASE("a fault of the machine in a design without a simulation ends the study with its sentence") {
  const TemporaryDirectory directory;
  RunSettings settings = isolated(directory / "s");
  settings.evaluate = [](const Communicator&, const Design&, const EvaluateOptions&) -> Evaluation {
    throw RuntimeError("the disk is full");
  };
  RecordingObserver observer;
  const StudySpec spec = fake_study(R"({"evaluators": ["cycle"]})");
  CHECK_THROWS_WITH(run_study(Communicator::serial(), spec, settings, observer),
                    Catch::Contains("the disk is full"));
}

TEST_CASE("a hang ends with the time limit") {
  const TemporaryDirectory directory;
  StudySpec spec = fake_study(designs({"hang", "good"}));
  spec.execution.time_limit_s = 1.0;
  RecordingObserver observer;
  const auto begin = std::chrono::steady_clock::now();
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, isolated(directory / "s"), observer);
  CHECK(seconds_since(begin) < 10.0);
  CHECK(outcome.ok == 2);
  CHECK_THAT(of(observer, "hang").reason, Catch::Contains("time limit of 1 s"));
}

TEST_CASE("a design that hit the time limit goes on where the limit is raised, and only then") {
  const TemporaryDirectory directory;
  StudySpec spec = fake_study(designs({"slow"}));
  spec.execution.time_limit_s = 0.5;
  RecordingObserver first, same, raised, none;
  run_study(Communicator::serial(), spec, isolated(directory / "s"), first);
  CHECK_THAT(of(first, "slow").reason, Catch::Contains("time limit of 0.5 s"));
  CHECK(std::filesystem::exists(directory / "s/designs/slow/checkpoint.h5"));
  run_study(Communicator::serial(), spec, isolated(directory / "s"), same);
  CHECK(same.started.empty());
  spec.execution.time_limit_s = 30.0;  // enough, with the checkpoint or without
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, isolated(directory / "s"), raised);
  CHECK(raised.started == std::vector<std::string>{"slow"});
  CHECK(of(raised, "slow").result.at("went_on") == true);
  CHECK(outcome.failed == 0);
  CHECK_THAT(outcome.notes[0], Catch::Contains("raised from 0.5 to 30 s"));
  CHECK_FALSE(std::filesystem::exists(directory / "s/designs/slow/checkpoint.h5"));
}

TEST_CASE("designs of the formula alone start no process, write no file and are recalled") {
  const TemporaryDirectory directory;
  RunSettings settings = isolated(directory / "s");
  settings.program = "/no/such/program";
  settings.evaluate = nullptr;  // the real one
  settings.margins = nullptr;
  const StudySpec spec = fake_study(R"({"evaluators": ["lindqvist"], "ranking": {"by": "lindqvist_breaking"},
      "include_baseline": false, "method": {"type": "grid", "variables": {
        "/operation/speed_kn": {"min": 1, "max": 6, "levels": 30},
        "/bow/bow_length_m": {"min": 10, "max": 33, "levels": 20}}}})");
  RecordingObserver first, second;
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, settings, first);
  CHECK(outcome.ok + outcome.infeasible == 600);
  CHECK(outcome.infeasible > 0);  // a bow of 10 m does not fit these angles
  CHECK(outcome.failed == 0);
  CHECK(std::filesystem::is_empty(directory / "s/designs"));
  CHECK(run_study(Communicator::serial(), spec, settings, second).recalled == 600);
  REQUIRE(first.finished.size() == 600);
  // Threads return their designs in the order they were planned: the store's order is the same on any
  // machine.
  CHECK(first.finished.front().name == "d001");
  CHECK(first.finished.back().name == "d600");
}

TEST_CASE("an impossible bow starts no process") {
  const TemporaryDirectory directory;
  RunSettings settings = isolated(directory / "s");
  settings.program = "/no/such/program";
  RecordingObserver observer;
  const StudySpec spec = fake_study(R"({"bow": {"stem_deg": 40}})");
  CHECK(run_study(Communicator::serial(), spec, settings, observer).infeasible == 1);
}

TEST_CASE("a program that cannot be started is the machine's fault, not the design's") {
  const TemporaryDirectory directory;
  RunSettings settings = isolated(directory / "s");
  settings.program = "/no/such/program";
  RecordingObserver observer;
  CHECK_THROWS_WITH(run_study(Communicator::serial(), fake_study(), settings, observer),
                    Catch::Contains("/no/such/program"));
  CHECK(Store::open_read_only(directory / "s/results.sqlite").everything().empty());
}

TEST_CASE("an interrupt ends the children at once") {
  const TemporaryDirectory directory;
  RunSettings settings = isolated(directory / "s");
  RecordingObserver observer;
  const auto begin = std::chrono::steady_clock::now();
  settings.stop = [&] { return seconds_since(begin) > 0.5; };
  const StudySpec spec = fake_study(designs({"hang", "hang more"}));
  CHECK(run_study(Communicator::serial(), spec, settings, observer).interrupted);
  CHECK(seconds_since(begin) < 8.0);
  for (const Evaluation& e : Store::open_read_only(directory / "s/results.sqlite").everything()) {
    CHECK(e.name == "baseline");
  }
}

TEST_CASE("a killed driver takes its children along, and the next run goes on") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(designs({"pid", "good"}));
  for (int kills = 0; kills < 3;
       ++kills) {  // more than the two of a crashing design: the driver is not the design
    const pid_t driver = fork();
    if (driver == 0) {
      RecordingObserver observer;
      run_study(Communicator::serial(), spec, isolated(directory / "s"), observer);
      _exit(0);
    }
    const std::string file = directory / "s/designs/pid/pid.txt";
    for (int i = 0; i < 500 && !std::filesystem::exists(file); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const pid_t child = std::stoi(read_text_file(file));
    REQUIRE(kill(child, 0) == 0);
    kill(driver, SIGKILL);
    waitpid(driver, nullptr, 0);
    for (int i = 0;
         i < 300 && kill(child, 0) == 0 &&
         read_text_file("/proc/" + std::to_string(child) + "/stat").find(") Z ") == std::string::npos;
         ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::error_code gone;
    const bool alive =
        std::filesystem::exists("/proc/" + std::to_string(child)) &&
        read_text_file("/proc/" + std::to_string(child) + "/stat").find(") Z ") == std::string::npos;
    CHECK_FALSE(alive);
    std::filesystem::remove(file, gone);
  }
  StudySpec quick = spec;
  quick.execution.time_limit_s = 0.5;
  RecordingObserver observer;
  const StudyOutcome outcome = run_study(Communicator::serial(), quick, isolated(directory / "s"), observer);
  CHECK_THAT(of(observer, "pid").reason, Catch::Contains("time limit"));
  CHECK(outcome.ok == 2);
}

TEST_CASE("designs of several ranks run under mpirun") {
  const TemporaryDirectory directory;
  StudySpec spec = fake_study(designs({"ranks", "crash"}));
  spec.execution.ranks_per_design = 2;
  RecordingObserver observer;
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, isolated(directory / "s"), observer);
  CHECK(outcome.ok == 2);
  CHECK(of(observer, "ranks").result.at("ranks") == 2);
  CHECK_THAT(of(observer, "crash").reason, Catch::Contains("signal 6") && Catch::EndsWith("about to crash"));
}

TEST_CASE("what the machine does to a design ends the study in words, and is not the design's failure") {
  const std::map<std::string, std::string> said = {
      {"disk full", "No space left"}, {"killed twice", "signal 9"}, {"no memory", "not enough memory"}};
  for (const auto& [name, words] : said) {
    for (const int ranks : {1, 2}) {
      CAPTURE(name, ranks);
      const TemporaryDirectory directory;
      StudySpec spec = fake_study(designs({name}));
      spec.execution.ranks_per_design = ranks;
      RecordingObserver observer;
      RunSettings settings = isolated(directory / "s");
      settings.jobs = 1;
      CHECK_THROWS_WITH(
          run_study(Communicator::serial(), spec, settings, observer),
          Catch::StartsWith(name) && Catch::Contains("the same command goes on") && Catch::Contains(words));
      const auto rows = Store::open_read_only(directory / "s/results.sqlite").everything();
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].name == "baseline");
    }
  }
}

TEST_CASE("a design whose process somebody kills goes on by itself, once") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudySpec spec = fake_study(designs({"killed once"}));
  CHECK(run_study(Communicator::serial(), spec, isolated(directory / "s"), observer).ok == 2);
}
