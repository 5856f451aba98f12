#include "study/run/run_study.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "base/json.h"
#include "study/store/design_files.h"
#include "tests/support/fake_runs.h"

using namespace icebow;

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
  for (const char* name :
       {"result.json", "evaluation.json", "ice_0000.vtp", "ice.pvd", "hull_pressure_0000.vtp"})
    write_text_file(design + "/" + name, "");
  write_text_file(design + "/checkpoint.h5", "");
  clear_design_directory(study, "one");
  CHECK(files() ==
        std::set<std::string>{"checkpoint.h5", "hull_pressure_0000.vtp", "ice.pvd", "ice_0000.vtp"});
  std::filesystem::create_symlink(own / "elsewhere", design + "/ice_0001.vtp");  // would be written through
  write_text_file(design + "/ice_0002.vtkhdf.tmp", "");
  clear_design_directory(study, "one");
  CHECK(files() ==
        std::set<std::string>{"checkpoint.h5", "hull_pressure_0000.vtp", "ice.pvd", "ice_0000.vtp"});
  std::filesystem::remove(design + "/checkpoint.h5");
  clear_design_directory(study, "one");
  CHECK(files().empty());
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
  write_text_file(directory / "victim/file", "mine");
  for (const char* name : {"results.sqlite", "results.sqlite.lock", "results.sqlite-wal"}) {
    std::filesystem::create_directories(directory / "u");
    std::filesystem::create_symlink(directory / "victim/file", directory / "u/" + name);
    CHECK_THROWS_WITH(run(spec, directory / "u"), Catch::Contains("is a link"));
    CHECK(read_text_file(directory / "victim/file") == "mine");
    std::filesystem::remove_all(directory / "u");
  }
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
