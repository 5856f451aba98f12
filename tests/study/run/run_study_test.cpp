#include "study/run/run_study.h"

#include <signal.h>

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <set>

#include "base/json.h"
#include "study/plan/ranking.h"
#include "study/run/failure.h"
#include "study/store/design_files.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

constexpr const char* grid_3_by_2 = R"({"method": {"type": "grid",
  "variables": {"/bow/stem_deg": {"values": [20, 30, 40]}, "/bow/waterline_deg": {"values": [28, 34]}}}})";
constexpr const char* optimisation =
    R"({"method": {"type": "optimise", "algorithm": "sbplx", "max_evaluations": 30,
  "tolerance": 0,
  "variables": {"/bow/stem_deg": {"min": 15, "max": 34}, "/bow/waterline_deg": {"min": 20, "max": 45}}}})";

StudyOutcome run(const StudySpec& spec, const RunSettings& settings, StudyObserver& observer) {
  return run_study(Communicator::serial(), spec, settings, observer);
}

StudyOutcome run(const StudySpec& spec, const std::string& directory) {
  RecordingObserver observer;
  return run(spec, fake_settings(directory), observer);
}

// What a user sees of a study, without times.
Json ranking_of(const std::string& directory) {
  const Store store = Store::open_read_only(directory + "/results.sqlite");
  return to_json(rank_designs(store.all(), store.fact("rank_by")));
}

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

// As a flipped bit, or somebody else, would.
void change_store(const std::string& directory, const std::string& sql) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open((directory + "/results.sqlite").c_str(), &database) == SQLITE_OK);
  CHECK(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  CHECK(sqlite3_changes(database) > 0);
  sqlite3_close(database);
}

}  // namespace

TEST_CASE("a grid study: store, ranking, files, outcome") {
  const TemporaryDirectory directory;
  RecordingObserver observer;
  const StudyOutcome outcome = run(fake_study(grid_3_by_2), fake_settings(directory / "s"), observer);
  CHECK(outcome.ok == 5);
  CHECK(outcome.infeasible == 2);
  CHECK(outcome.failed == 0);
  CHECK(outcome.recalled == 0);
  CHECK(outcome.best == "d001");  // (20, 28)
  CHECK(observer.planned.designs.size() == 7);
  CHECK(observer.started.size() == 7);
  CHECK(observer.finished.size() == 7);
  CHECK(observer.progress.size() == 5);
  CHECK(observer.last_progress.steps == 10);
  CHECK(observer.ends == 1);
  CHECK(read_json_file(directory / "s/study.json") == fake_document(grid_3_by_2));
  const Json result = read_json_file(directory / "s/designs/d005/result.json");
  CHECK(result.at("status") == "infeasible");
  CHECK(result.at("reason") == "stem beyond 35 deg");
  CHECK(result.at("parameters").at("/bow/stem_deg") == 40);
  const Store store = Store::open_read_only(directory / "s/results.sqlite");
  CHECK(store.fact("state") == "finished");
  CHECK(store.fact("seed") == "1");
  CHECK(store.fact("command") == "icebow run fake.json");
  CHECK(Json::parse(store.fact("study")) == fake_document(grid_3_by_2));
}

TEST_CASE("the same command again evaluates nothing") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(grid_3_by_2);
  run(spec, directory / "s");
  const Json before = ranking_of(directory / "s");
  RecordingObserver observer;
  const StudyOutcome outcome = run(spec, fake_settings(directory / "s"), observer);
  CHECK(observer.started.empty());
  CHECK(observer.recalled.size() == 7);
  CHECK(outcome.recalled == 7);
  CHECK(outcome.ok == 5);
  CHECK(ranking_of(directory / "s") == before);
}

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

TEST_CASE("a load that is not a number is never the best") {
  const TemporaryDirectory directory;
  const StudySpec spec =
      fake_study(R"({"designs": [{"name": "not a number", "set": {"bow": {"stem_deg": 20}}}]})");
  CHECK(run(spec, directory / "s").best == "baseline");
}

TEST_CASE("a changed study file: the same ships are recalled under their new names, with their files") {
  const TemporaryDirectory directory;
  const std::string s = directory / "s";
  run(fake_study(R"({"designs": [{"name": "A", "set": {"bow": {"stem_deg": 30}}}]})"), s);
  write_text_file(s + "/designs/A/note", "of 30");
  write_text_file(s + "/designs/baseline/note", "of 25");
  RecordingObserver observer;  // baseline and A change places, B is new
  const StudyOutcome outcome =
      run(fake_study(R"({"bow": {"stem_deg": 30}, "designs": [{"name": "A", "set": {"bow": {"stem_deg": 25}}},
                         {"name": "B", "set": {"bow": {"stem_deg": 22}}}]})"),
          fake_settings(s), observer);
  CHECK(observer.started == std::vector<std::string>{"B"});
  CHECK(read_text_file(s + "/designs/A/note") == "of 25");
  CHECK(read_text_file(s + "/designs/baseline/note") == "of 30");
  CHECK(read_json_file(s + "/designs/A/result.json").at("design") == "A");
  REQUIRE(outcome.notes.size() == 1);
  CHECK_THAT(outcome.notes[0], Catch::Contains("has changed"));
}

TEST_CASE("the ranking is of the present study; an earlier one's designs wait for its return") {
  const TemporaryDirectory directory;
  const std::string s = directory / "s";
  const StudySpec one = fake_study(R"({"designs": [{"name": "A", "set": {"bow": {"stem_deg": 30}}}]})");
  const StudySpec two = fake_study(R"({"designs": [{"name": "A", "set": {"bow": {"stem_deg": 22}}}]})");
  run(one, s);
  write_text_file(s + "/designs/A/note", "of 30");
  const Json ranking = ranking_of(s);
  run(two, s);
  CHECK(ranking_of(s).at("designs").size() == 2);
  CHECK(ranking_of(s) != ranking);
  CHECK_FALSE(std::filesystem::exists(s + "/designs/A/note"));
  RecordingObserver observer;
  run(one, fake_settings(s), observer);
  CHECK(observer.started.empty());
  CHECK(ranking_of(s) == ranking);
  CHECK(read_text_file(s + "/designs/A/note") == "of 30");
}

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
  CHECK(ranking.rows[0].evaluation.parameters.at("/bow/stem_deg") == Approx(20).margin(0.5));
  CHECK(ranking.rows[0].evaluation.parameters.at("/bow/waterline_deg") == Approx(30).margin(0.5));
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

TEST_CASE("a point the reader rejects is a failed design, not the end") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(R"({"method": {"type": "grid", "variables": {
    "/bow/draft_m": {"values": [6, 12]}, "/bow/depth_m": {"values": [10, 16]}}}})");
  const StudyOutcome outcome = run(spec, directory / "s");
  CHECK(outcome.ok == 4);
  CHECK(outcome.failed == 1);  // a draught of 12 m in a depth of 10 m
  CHECK_THAT(Store::open_read_only(directory / "s/results.sqlite").find_name("d002")->reason,
             Catch::Contains("/bow/"));
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

TEST_CASE("a directory in use is refused, and a study.json of somebody else is kept") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study();
  run(spec, directory / "s");
  {
    const Store held = Store::open(directory / "s/results.sqlite");
    CHECK_THROWS_WITH(run(spec, directory / "s"), Catch::Contains("another icebow run"));
  }
  std::filesystem::create_directories(directory / "mine");
  write_text_file(directory / "mine/study.json", "mine");
  CHECK_THROWS_AS(run(spec, directory / "mine"), InputError);
  CHECK(read_text_file(directory / "mine/study.json") == "mine");
}

TEST_CASE("a directory is emptied for a design, but for what an interrupted simulation goes on with") {
  const TemporaryDirectory own;
  const std::string study = own / "study", design = design_directory(study, "one");
  const auto files = [&] {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(design))
      names.insert(entry.path().filename().string());
    return names;
  };
  clear_design_directory(study, "one");
  for (const char* name : {"result.json", "evaluation.json", "ice_0000.vtp", "ice.pvd", "hull_0000.vtp"})
    write_text_file(design + "/" + name, "");
  write_text_file(design + "/checkpoint.h5", "");
  clear_design_directory(study, "one");
  CHECK(files() == std::set<std::string>{"checkpoint.h5", "hull_0000.vtp", "ice.pvd", "ice_0000.vtp"});
  std::filesystem::remove(design + "/checkpoint.h5");
  clear_design_directory(study, "one");
  CHECK(files().empty());
}

TEST_CASE("a damaged row is one design without a result, evaluated again where that is asked for") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(grid_3_by_2);
  run(spec, directory / "s");
  const Json before = ranking_of(directory / "s");
  change_store(directory / "s",
               "UPDATE evaluations SET result = replace(result, '1000.0', '1001.0') WHERE name = 'd001'");
  const Json damaged = ranking_of(directory / "s");
  CHECK(damaged.at("designs").size() == before.at("designs").size());
  CHECK(damaged.at("designs").at(0).at("design") != "d001");
  RecordingObserver second, third;
  const StudyOutcome outcome = run(spec, fake_settings(directory / "s"), second);
  CHECK(second.started.empty());
  CHECK(outcome.failed == 1);
  REQUIRE(outcome.notes.size() == 1);
  CHECK_THAT(outcome.notes[0], Catch::StartsWith("d001: its row in results.sqlite is damaged") &&
                                   Catch::Contains("--retry-failed"));
  RunSettings settings = fake_settings(directory / "s");
  settings.retry_failed = true;
  CHECK(run(spec, settings, third).failed == 0);
  CHECK(third.started == std::vector<std::string>{"d001"});
  CHECK(ranking_of(directory / "s") == before);
}

TEST_CASE("an optimiser evaluates a damaged row again, for its next points depend on it") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study(optimisation);
  run(spec, directory / "s");
  const Json before = ranking_of(directory / "s");
  change_store(directory / "s", "UPDATE evaluations SET reason = 'x' WHERE name IN ('d002', 'd005')");
  RecordingObserver observer;
  run(spec, fake_settings(directory / "s"), observer);
  CHECK(observer.started == std::vector<std::string>{"d002", "d005"});
  CHECK(ranking_of(directory / "s") == before);
}

TEST_CASE("a row whose key or name is damaged is told, and does not take a good one's place") {
  for (const char* change :
       {"key = 'f' || substr(key, 2)", "name = 'd009'", "name = '../../etc'", "status = 'failed'",
        "wall_seconds = 7", "parameters = '{}'", "result = '[[['", "digest = NULL"}) {
    CAPTURE(change);
    const TemporaryDirectory directory;
    const StudySpec spec = fake_study(grid_3_by_2);
    run(spec, directory / "s");
    const Json before = ranking_of(directory / "s");
    change_store(directory / "s", std::string("UPDATE evaluations SET ") + change + " WHERE name = 'd001'");
    int told = 0;
    for (const Evaluation& e : Store::open_read_only(directory / "s/results.sqlite").all())
      told += e.status == EvaluationStatus::damaged;
    CHECK(told == 1);
    RunSettings settings = fake_settings(directory / "s");
    settings.retry_failed = true;
    RecordingObserver observer;
    run(spec, settings, observer);
    CHECK(ranking_of(directory / "s") == before);
  }
}

TEST_CASE("what leads out of a study's directory is not followed") {
  const TemporaryDirectory directory;
  const StudySpec spec = fake_study();
  std::filesystem::create_directories(directory / "victim");
  write_text_file(directory / "victim/checkpoint.h5", "");
  write_text_file(directory / "victim/precious", "mine");
  std::filesystem::create_directories(directory / "s/designs");
  std::filesystem::create_directory_symlink(directory / "victim", directory / "s/designs/baseline");
  CHECK_THROWS_WITH(run(spec, directory / "s"), Catch::Contains("is a link"));
  CHECK(read_text_file(directory / "victim/precious") == "mine");
  std::filesystem::create_directories(directory / "t");
  std::filesystem::create_directory_symlink(directory / "victim", directory / "t/designs");
  CHECK_THROWS_WITH(run(spec, directory / "t"), Catch::Contains("is a link"));
  for (const char* name : {"../victim", "..", "a/b", ""})
    CHECK_THROWS_AS(design_directory(directory / "s", name), RuntimeError);
}

TEST_CASE("a hypercube of more samples keeps those that were paid for") {
  const auto study = [](int samples) {
    return fake_study(R"({"include_baseline": false, "method": {"type": "latin_hypercube", "variables": {
      "/bow/stem_deg": {"min": 15, "max": 34}, "/bow/waterline_deg": {"min": 20, "max": 45}}, "samples": )" +
                      std::to_string(samples) + "}}");
  };
  const TemporaryDirectory directory;
  RecordingObserver three, six, again, twelve, back;
  run(study(3), fake_settings(directory / "s"), three);
  const StudyOutcome grown = run(study(6), fake_settings(directory / "s"), six);
  CHECK(three.started.size() == 3);
  CHECK(six.recalled == std::vector<std::string>{"d001", "d002", "d003"});
  CHECK(six.started == std::vector<std::string>{"d004", "d005", "d006"});
  REQUIRE(!grown.notes.empty());
  CHECK_THAT(grown.notes[0],
             Catch::Contains("3 samples of before stay") && Catch::Contains("\"extends\": [3]"));
  run(study(6), fake_settings(directory / "s"), again);  // the same file, which does not say "extends"
  CHECK(again.started.empty());
  CHECK(read_json_file(directory / "s/study.json").at("method").at("extends") == Json({3}));
  run(study(12), fake_settings(directory / "s"), twelve);
  CHECK(twelve.recalled.size() == 6);
  run(study(3), fake_settings(directory / "s"), back);
  CHECK(back.recalled == three.started);
}

TEST_CASE("nothing feasible is an outcome of its own, whatever the baseline outside the ranges is") {
  const std::string variables =
      R"("variables": {"/bow/stem_deg": {"min": 36, "max": 40}, "/bow/waterline_deg": {"min": 20, "max": 45}})";
  for (const char* method : {R"("type": "latin_hypercube", "samples": 4,)", R"("type": "optimise",)"}) {
    const TemporaryDirectory directory;
    const StudySpec spec = fake_study("{\"method\": {" + std::string(method) + variables + "}}");
    RecordingObserver observer;
    const StudyOutcome outcome = run(spec, fake_settings(directory / "s"), observer);
    CHECK(outcome.nothing_feasible);
    CHECK(outcome.ok == 1);
    CHECK_THAT(outcome.notes[0],
               Catch::StartsWith("/bow/stem_deg is 25 in the file, outside its range of 36 to 40"));
    if (spec.method.type == MethodType::optimise)
      CHECK_THAT(outcome.notes.back(), Catch::Contains("none of which has a value"));
  }
  const TemporaryDirectory directory;
  CHECK_FALSE(run(fake_study(grid_3_by_2), directory / "s").nothing_feasible);
  CHECK(run(fake_study(R"({"bow": {"stem_deg": 36}})"), directory / "t").nothing_feasible);
}

TEST_CASE("an optimiser's start is one of its points, and costs nothing where it is the baseline") {
  CHECK(plan_study(fake_study(optimisation)).proposals == 29);  // the baseline is within the ranges
  CHECK(plan_study(
            fake_study(R"({"include_baseline": false, "method": {"type": "optimise", "max_evaluations": 30,
    "variables": {"/bow/stem_deg": {"min": 15, "max": 34}}}})"))
            .proposals == 30);
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
