// Programs as evaluators: small shell scripts stand in for a yard's own.
#include "study/evaluate/program_evaluator.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "base/errors.h"
#include "study/evaluate/evaluate.h"
#include "study/plan/ranking.h"
#include "study/store/store.h"
#include "tests/support/fake_study.h"

using namespace icebow;

namespace {

ProgramEvaluator shell(const std::string& script, double limit = 20.0) {
  return {"yard", {"sh", "-c", script}, limit};
}

ProgramOutcome outcome_of(const std::string& script, double limit = 20.0) {
  const TemporaryDirectory directory;
  return run_program(shell(script, limit), program_input(fake_study().baseline, "one"), directory / "",
                     nullptr);
}

// The stem angle as a load in kilonewtons: what it reads, by sed.
constexpr const char* stem_as_load = R"(sed -n 's/.*"stem_deg":\([0-9]*\).*/{"resistance_N": \1000}/p')";

StudySpec with_yard(const std::string& script, const std::string& more = "{}") {
  Json document = fake_document(more);
  document["evaluators"] = {{{"name", "yard"}, {"command", {"sh", "-c", script}}, {"time_limit_s", 20}}};
  document["ranking"] = {{"by", "/programs/yard/resistance_N"}};
  return read_study(document, "fake.json");
}

}  // namespace

TEST_CASE("a program gets the ship on stdin and its numbers come back") {
  const ProgramOutcome o = outcome_of("cat");
  REQUIRE(o.reason.empty());
  CHECK(o.output.at("ship").at("stem_deg").get<double>() == Approx(25));
  CHECK(o.output.at("ship").at("beam_m") == 23.0);
  CHECK(o.output.at("ice").at("flexural_strength_Pa") == 5e5);
  CHECK(o.output.at("speed_m_s").get<double>() == Approx(2.0578).epsilon(1e-4));  // 4 kn, given to 5 digits
  CHECK(o.output.at("design") == "one");
}

TEST_CASE("what a program does wrong is said in words") {
  CHECK_THAT(outcome_of("echo bad shape >&2; exit 3").reason, Catch::Contains("exit code 3: bad shape"));
  CHECK_THAT(outcome_of("echo 12,5 kN").reason, Catch::StartsWith("printed no JSON"));
  CHECK_THAT(outcome_of("echo '[1]'").reason, Catch::Contains("no object"));
  CHECK_THAT(outcome_of("echo '{\"text\": \"x\"}'").reason, Catch::Contains("without a number"));
  CHECK_THAT(outcome_of("kill -SEGV $$").reason, Catch::Contains("signal 11"));
  CHECK_THAT(outcome_of("printf '{\"a\": 1}'").output.dump(), Catch::Equals("{\"a\":1}"));  // no line end
  const ProgramOutcome slow = outcome_of("sleep 30", 0.2);
  CHECK(slow.timed_out);
  CHECK_THAT(slow.reason, Catch::Contains("time limit of 0.2 s"));
  CHECK_THAT(outcome_of("echo '{\"a\": 1, \"a\": 2}'").reason, Catch::Contains("given twice"));
  const ProgramOutcome no = outcome_of("echo '{\"infeasible\": \"too deep\"}'");
  CHECK((no.infeasible && no.reason == "too deep"));
  CHECK_THROWS_WITH(run_program({"yard", {"/no/such/program"}, 1.0}, {}, "", nullptr),
                    Catch::Contains("/no/such/program"));
}

TEST_CASE("a program that floods its stdout or stderr is ended, in lines, in one line or in zeros") {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* flood : {"yes", "yes | tr -d '\n'", "cat /dev/zero"})
    CHECK_THAT(outcome_of(flood, 600.0).reason, Catch::Contains("printed more than 16 MB"));
  const TemporaryDirectory directory;
  const ProgramOutcome outcome = run_program(shell("yes >&2", 600.0), {}, directory / "", nullptr);
  CHECK_THAT(outcome.reason, Catch::Contains("16 MB to its stderr"));
  CHECK(std::filesystem::file_size(directory / "yard.log") == 16 * 1024 * 1024);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(100));  // limits of 600 s are not met
}

TEST_CASE("a program that somebody kills is started again, once; then the machine is at fault") {
  const TemporaryDirectory directory;
  const std::string mark = directory / "mark";
  const ProgramOutcome once =
      outcome_of("[ -e " + mark + " ] || { touch " + mark + "; kill -KILL $$; }; echo '{\"x_N\": 1}'");
  CHECK((once.reason.empty() && once.output.at("x_N") == 1));
  CHECK_THROWS_AS(outcome_of("kill -KILL $$"), RuntimeError);
}

TEST_CASE("a key holds the program: its name, its words and the bytes of its files") {
  const TemporaryDirectory directory;
  const std::string file = directory / "f.sh", moved = directory / "g.sh";
  write_text_file(file, "echo");
  write_text_file(moved, "echo");
  const auto key = [&](const std::string& name, const std::string& word) {
    return evaluation_key(fake_study().baseline, {false, false, false, {{name, {"sh", word}, 1.0}}});
  };
  const std::string before = key("yard", file);
  CHECK(key("yard", moved) == before);
  CHECK(key("other", file) != before);
  CHECK(key("yard", "-x") != before);
  write_text_file(file, "echo changed");
  CHECK(key("yard", file) != before);
  CHECK(evaluation_key(fake_study().baseline, {true, true}) ==
        evaluation_key(fake_study().baseline, {true, true, false, {}}));
}

TEST_CASE("a yard's own formula ranks beside ours, in threads, and an optimiser goes by it") {
  const TemporaryDirectory directory;
  RunSettings settings;
  settings.directory = directory / "s";
  settings.launcher = Launcher::isolated;
  settings.program = "/no/such/program";  // no child of ours
  RecordingObserver observer;
  const StudySpec spec =
      with_yard(stem_as_load,
                R"({"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [22, 23, 24]}}}})");
  const StudyOutcome outcome = run_study(Communicator::serial(), spec, settings, observer);
  CHECK(outcome.ok == 4);
  CHECK(outcome.best == "d001");
  const Store store = Store::open_read_only(directory / "s/results.sqlite");
  const Ranking ranking = rank_designs(store.all(), store.fact("rank_by"));
  CHECK(ranking.rows[0].value == 22000.0);
  CHECK_FALSE(ranking.rows[1].tied_with_best);
  RecordingObserver again;
  run_study(Communicator::serial(), with_yard("exit 1"), settings, again);
  CHECK(again.finished.at(0).status == EvaluationStatus::failed);
  CHECK_THAT(again.finished.at(0).reason, Catch::Contains("\"yard\" ended with exit code 1"));
}

TEST_CASE("programs in a study file: mistakes by pointer") {
  const auto pointer = [](const std::string& entry, const std::string& by = "/programs/yard/x_N") {
    Json document = fake_document();
    document["evaluators"] = {"lindqvist", Json::parse(entry)};
    document["ranking"] = {{"by", by}};
    try {
      read_study(document, "t.json");
    } catch (const InputError& error) {
      return error.mistakes().at(0).pointer;
    }
    return std::string();
  };
  CHECK(pointer(R"({"name": "yard", "command": ["sh"]})").empty());
  CHECK(pointer(R"({"name": "yard", "command": ["sh"]})", "lindqvist_breaking").empty());
  CHECK(pointer(R"({"name": "my yard", "command": ["sh"]})") == "/evaluators/1/name");
  CHECK(pointer(R"({"name": "lindqvist", "command": ["sh"]})") == "/evaluators/1/name");
  CHECK(pointer(R"({"name": "yard", "command": "sh"})") == "/evaluators/1/command");
  CHECK(pointer(R"({"name": "yard", "command": ["sh"], "time_limit_s": 0})") == "/evaluators/1/time_limit_s");
  CHECK(pointer(R"({"name": "yard", "comand": ["sh"], "command": ["sh"]})") == "/evaluators/1/comand");
  CHECK(pointer(R"({"name": "yard", "command": ["sh"]})", "/programs/yrad/x_N") == "/ranking/by");
  CHECK(pointer(R"({"name": "yard", "command": ["sh"]})", "/programs/yard/x") == "/ranking/by");
}
