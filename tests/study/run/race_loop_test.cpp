// Studies that decide, with voyages whose record is a formula of design and length.
#include "study/run/race_loop.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <random>

#include "solver/model/drift.h"
#include "solver/model/statistics.h"
#include "study/plan/ranking.h"
#include "study/store/design_files.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

namespace fs = std::filesystem;

const char* three_bows = R"({"sheet": {"window_ahead_m": 40},
  "operation": {"advance_m": 75, "steady_from_m": 35},
  "method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [20, 23, 32]}}},
  "decide": {"best_within": 0.05}})";

// Two samples a metre; a longer voyage begins as the shorter one. The loads of stems of 20 and 23 deg lie
// within 9 %, that of 32 deg is far above.
LoadStatistics record_of(const Case& c) {
  std::mt19937_64 random(static_cast<std::uint64_t>(1000.0 * c.bow.angles.stem));
  std::normal_distribution<double> normal;
  const double mean = fake_load(degrees(c.bow.angles.stem), 30.0);
  std::vector<double> record;
  for (double x = c.steady_from; x < c.advance; x += 0.5) {
    const double n = normal(random);
    record.push_back(mean * (0.5 + 0.5 * n * n));
  }
  return series_statistics(record);
}

Evaluation sail(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  Evaluation e = fake_evaluate(comm, design, options);
  if (e.status != EvaluationStatus::ok) return e;
  const LoadStatistics s = record_of(*design.given);
  e.result["metrics"]["full_scale"] = {{"mean_load_N", s.mean}, {"mean_load_ci95_N", s.ci95}};
  e.result["metrics"]["effective_samples"] = s.effective_samples;
  e.result["simulation"] = {{"wall_s", 36.0 * design.given->advance}};  // 0.01 core hours a metre
  e.result["provenance"] = {{"ranks", 1}};
  if (design.sail_to > 0.0) e.result["sailed_to_m"] = design.sail_to;
  if (!options.directory.empty() && design.sail_to > 0.0) {
    fs::create_directories(options.directory);
    write_text_file(options.directory + "/" + checkpoint_name, "the state of its end");
  }
  return e;
}

RunSettings settings(const std::string& directory) {
  RunSettings s = fake_settings(directory);
  s.evaluate = sail;
  return s;
}

StudyOutcome run(const std::string& patch, RunSettings s, RecordingObserver* observer = nullptr) {
  RecordingObserver silent;
  return run_study(Communicator::serial(), fake_study(patch), s, observer ? *observer : silent);
}

Store store_in(const std::string& directory) {
  return Store::open_read_only(directory + "/results.sqlite");
}

double sailed(const Store& store, const std::string& name) {
  return store.find_name(name)->result.at("sailed_to_m").get<double>();
}

Json rows(const std::string& directory) {
  Json all = Json::array();
  for (const Evaluation& e : store_in(directory).all()) all.push_back(to_json(e));
  for (Json& row : all) row.erase("wall_seconds");
  return all;
}

std::string with(const std::string& patch) {
  Json document = Json::parse(three_bows);
  document.merge_patch(Json::parse(patch));
  return document.dump();
}

}  // namespace

TEST_CASE("a study that decides sails on what is open, and rests what is out") {
  const TemporaryDirectory folder;
  const std::string directory = folder / "study";
  const StudyOutcome outcome = run(three_bows, settings(directory));
  CHECK(outcome.best == "d001");
  const Store store = store_in(directory);
  const RaceRecord record = read_race(store);
  REQUIRE(record.state == RaceState::decided);
  CHECK(record.legs.size() > 1);
  CHECK(record.legs.back().leader == "d001");
  CHECK(record.legs.back().most_above_best <= 0.05);
  CHECK(sailed(store, "d001") > 75.0);
  CHECK(sailed(store, "d003") == 75.0);
  CHECK(place_in_race(record, "d001") == "leads");
  CHECK(place_in_race(record, "d003") == "out in leg 1");
  CHECK_THAT(outcome.notes.back(), Catch::StartsWith("Decided: d001"));
  CHECK_FALSE(fs::exists(design_directory(directory, "d001") + "/" + checkpoint_name));
}

TEST_CASE("a voyage that drifts is sailed on, and does not win before it has come to rest") {
  const TemporaryDirectory folder;
  // The steep bow, in truth the worst, begins far too low.
  RunSettings s = settings(folder / "study");
  bool always = false;
  s.evaluate = [&](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = sail(comm, d, o);
    const bool drifts = d.name == "d003" && (always || d.given->advance < 150.0);
    if (drifts) e.result["metrics"]["full_scale"]["mean_load_N"] = 0.2e6;
    e.result["metrics"]["drift"] = {{"relative", drifts ? 0.8 : 0.01}, {"p", drifts ? 1e-4 : 0.5}};
    return e;
  };
  const StudyOutcome outcome = run(three_bows, s);
  RaceRecord record = read_race(store_in(folder / "study"));
  REQUIRE(record.legs.size() > 1);
  CHECK(record.legs[0].leader == "d003");
  CHECK(record.legs[0].in.size() == 4);  // it puts nobody out
  CHECK(record.legs[0].drifts == std::map<std::string, double>{{"d003", 0.8}});
  CHECK(record.state == RaceState::decided);
  CHECK(outcome.best == "d001");
  CHECK(sailed(store_in(folder / "study"), "d003") >= 150.0);

  always = true;
  s.directory = folder / "never";
  const StudyOutcome never = run(with(R"({"decide": {"best_within": 0.05, "longest_m": 200}})"), s);
  record = read_race(store_in(folder / "never"));
  CHECK(record.state == RaceState::longest);
  CHECK(place_in_race(record, "d003") == "leads, but drifts");
  CHECK_THAT(never.notes.back(),
             Catch::Contains("Not decided") &&
                 Catch::Contains("The load of d003 (its second half 80 % above the first)") &&
                 Catch::Contains("operation.steady_from_m"));
}

TEST_CASE("a race that is cut short anywhere ends as one that was not") {
  const TemporaryDirectory folder;
  run(three_bows, settings(folder / "whole"));
  int evaluations = 0;
  bool ended = false;
  for (int tries = 0; tries < 100 && !ended; ++tries) {
    RunSettings s = settings(folder / "parts");
    const int until = evaluations + 1;  // one more each time
    s.stop = [&] { return evaluations >= until; };
    s.evaluate = [&](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
      ++evaluations;
      return sail(comm, d, o);
    };
    ended = !run(three_bows, s).interrupted;
    CHECK(store_in(folder / "parts").all().size() <= 4);
  }
  CHECK(ended);
  CHECK(rows(folder / "parts") == rows(folder / "whole"));
  const auto race = [&](const char* name) { return to_json(read_race(store_in(folder / name))); };
  CHECK(race("parts") == race("whole"));
}

TEST_CASE("a decided race that is run again stays as it is and evaluates nothing") {
  const TemporaryDirectory folder;
  run(three_bows, settings(folder / "study"));
  const Json before = rows(folder / "study"), race = to_json(read_race(store_in(folder / "study")));
  RecordingObserver observer;
  run(three_bows, settings(folder / "study"), &observer);
  CHECK(observer.started.empty());
  CHECK(rows(folder / "study") == before);
  CHECK(to_json(read_race(store_in(folder / "study"))) == race);
}

TEST_CASE("results paid for before the study decided are its first leg, and the way back is free as well") {
  const TemporaryDirectory folder;
  const std::string plain = with(R"({"decide": null})");
  run(plain, settings(folder / "study"));
  RecordingObserver observer;
  run(three_bows, settings(folder / "study"), &observer);
  CHECK(std::count(observer.started.begin(), observer.started.end(), "d003") == 0);
  CHECK(store_in(folder / "study").all().size() == 4);
  RecordingObserver back;
  run(plain, settings(folder / "study"), &back);
  CHECK(std::count(back.started.begin(), back.started.end(), "d003") == 0);  // it never sailed farther
  CHECK(std::count(back.started.begin(), back.started.end(), "d001") == 1);
  CHECK_FALSE(read_race(store_in(folder / "study")).given());
}

TEST_CASE("a race without an answer says what ended it, and goes on where that is raised") {
  const TemporaryDirectory folder;
  const std::string poor = with(R"({"decide": {"best_within": 0.001, "budget_core_h": 6}})");
  const StudyOutcome outcome = run(poor, settings(folder / "study"));
  RaceRecord record = read_race(store_in(folder / "study"));
  CHECK(record.state == RaceState::budget);
  CHECK(record.legs.back().core_hours <= 6.0 * (1.0 + 1e-6));
  CHECK_THAT(outcome.notes.back(), Catch::Contains("Not decided") && Catch::Contains("decide.budget_core_h"));
  CHECK(fs::exists(design_directory(folder / "study", "d001") + "/" + checkpoint_name));
  const double before = sailed(store_in(folder / "study"), "d001");
  run(with(R"({"decide": {"best_within": 0.001, "budget_core_h": 12}})"), settings(folder / "study"));
  CHECK(sailed(store_in(folder / "study"), "d001") > before);

  run(with(R"({"decide": {"best_within": 0.001, "longest_m": 100}})"), settings(folder / "short"));
  record = read_race(store_in(folder / "short"));
  CHECK(record.state == RaceState::longest);
  CHECK(sailed(store_in(folder / "short"), "d001") == 100.0);
}

TEST_CASE("a voyage that fails when it is sailed on keeps what it has sailed") {
  const TemporaryDirectory folder;
  RunSettings s = settings(folder / "study");
  s.evaluate = [&](const Communicator& comm, const Design& d, const EvaluateOptions& o) {
    Evaluation e = sail(comm, d, o);
    if (d.name == "d002" && d.sail_to > 75.0) {
      e.status = EvaluationStatus::failed;
      e.reason = "unstable";
    }
    return e;
  };
  const StudyOutcome outcome = run(three_bows, s);
  CHECK(outcome.failed == 0);
  CHECK(sailed(store_in(folder / "study"), "d002") == 75.0);
  CHECK(read_race(store_in(folder / "study")).state != RaceState::sailing);
  CHECK(std::any_of(outcome.notes.begin(), outcome.notes.end(), [](const std::string& note) {
    return note.find("d002: cannot be sailed on: unstable") != std::string::npos;
  }));
}

TEST_CASE("where those that were in have left the study, the others race on") {
  const TemporaryDirectory folder;
  const std::string named = with(R"({"method": null, "include_baseline": false, "designs": [
    {"name": "flat", "set": {"bow": {"stem_deg": 20}}}, {"name": "steep", "set": {"bow": {"stem_deg": 32}}},
    {"name": "steeper", "set": {"bow": {"stem_deg": 33}}}]})");
  run(named, settings(folder / "study"));
  REQUIRE(place_in_race(read_race(store_in(folder / "study")), "steep") == "out in leg 1");
  Json fewer = Json::parse(named);
  fewer["designs"].erase(0);
  CHECK(run(fewer.dump(), settings(folder / "study")).best == "steep");
  CHECK_THAT(place_in_race(read_race(store_in(folder / "study")), "steep"), !Catch::StartsWith("out"));
}

TEST_CASE("a name that stands for another ship makes another race") {
  const TemporaryDirectory folder;
  run(three_bows, settings(folder / "study"));
  REQUIRE(place_in_race(read_race(store_in(folder / "study")), "d003") == "out in leg 1");  // 32 deg
  const StudyOutcome outcome =
      run(with(R"({"method": {"variables": {"/bow/stem_deg": {"values": [32, 30, 20]}}}})"),
          settings(folder / "study"));
  CHECK(outcome.best == "d003");  // 20 deg now
  CHECK(place_in_race(read_race(store_in(folder / "study")), "d003") == "leads");
}

TEST_CASE("a study that cannot decide is told why") {
  const auto refused = [](const std::string& patch, const std::string& words) {
    CHECK_THROWS_WITH(fake_study(with(patch)), Catch::Contains(words));
  };
  refused(R"({"sheet": null})", "/sheet/window_ahead_m");
  refused(R"({"repeats": 3})", "/repeats");
  refused(R"({"evaluators": ["lindqvist", "cycle"]})", "/cycle/voyages");
  refused(R"({"operation": {"stop_when_ci95_below": 0.1}})", "/operation/stop_when_ci95_below");
  refused(R"({"method": {"type": "optimise",
                          "variables": {"/bow/stem_deg": {"values": null, "min": 20, "max": 30}}}})",
          "not optimise");
  refused(R"({"decide": {"best_within": 2}})", "/decide/best_within");
}
