// Rows of the store that are not what was written.
#include <sqlite3.h>
#include <catch2/catch.hpp>

#include "tests/support/fake_runs.h"

using namespace icebow;

namespace {

// As a flipped bit, or somebody else, would.
void change_store(const std::string& directory, const std::string& sql) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open((directory + "/results.sqlite").c_str(), &database) == SQLITE_OK);
  CHECK(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  CHECK(sqlite3_changes(database) > 0);
  sqlite3_close(database);
}

}  // namespace

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
