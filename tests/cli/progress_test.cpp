#include "cli/progress.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "cli/text_table.h"

using namespace icebow;

namespace {

Progress at(std::int64_t step, std::int64_t steps) {
  Progress p;
  p.step = step;
  p.steps = steps;
  p.advance = 0.5;
  p.load = 35.25;
  return p;
}

Evaluation evaluated(const std::string& name, EvaluationStatus status, const std::string& reason) {
  Evaluation e;
  e.name = name;
  e.status = status;
  e.reason = reason;
  e.wall_seconds = 61;
  e.result = {{"metrics", {{"full_scale", {{"mean_load_N", 969000.0}}}}}};
  return e;
}

// Of a temporary file, which is closed.
std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

// What a display writes in a small study.
std::string written(ProgressDisplay::Mode mode, bool colour) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  {
    ProgressDisplay display(file, mode, colour);
    StudyPlan plan;
    plan.designs.resize(2);
    display.on_planned(plan);
    Design baseline;
    baseline.name = "baseline";
    display.on_started(baseline);
    display.on_progress("baseline", at(50, 100));
    display.on_finished(evaluated("baseline", EvaluationStatus::ok, ""), false);
    display.on_finished(evaluated("Bad", EvaluationStatus::failed, "unstable at step 7\nmore"), true);
    display.on_study_finished({});
  }
  return contents(file);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the time to go follows from what was computed, not from what was stored") {
  ProgressState state;
  state.planned(10, 0);
  CHECK(std::isnan(state.eta(5.0)));
  for (int i = 0; i < 4; ++i) state.finished("stored", true);
  CHECK(std::isnan(state.eta(5.0)));
  state.started("a", 0.0);
  state.progressed("a", at(1, 2));
  CHECK(state.eta(10.0) == Approx(10.0 * 5.5 / 0.5));
  state.finished("a", false);
  CHECK(state.eta(20.0) == Approx(100.0));
  CHECK(state.fraction() == Approx(0.5));
  CHECK(ProgressState::eta({10.0, at(1, 4)}, 20.0) == Approx(30.0));
}

TEST_CASE("designs an optimiser proposes use up its allowance") {
  ProgressState state;
  state.planned(1, 3);
  state.finished("baseline", false);
  CHECK(state.fraction() == Approx(0.25));
  state.finished("d001", false);
  CHECK(state.total() == 2);
  CHECK(state.fraction() == Approx(0.5));
  state.finished("d002", false);
  state.finished("d003", false);
  CHECK(state.fraction() == Approx(1.0));
}

TEST_CASE("without a terminal there are plain lines only") {
  const std::string text = written(ProgressDisplay::Mode::lines, false);
  CHECK(text.find('\033') == std::string::npos);
  CHECK(has(text, "[1/2] baseline  ok, mean load 969.0 kN  1:01\n"));
  CHECK(has(text, "[2/2] Bad  failed: unstable at step 7  (stored)\n"));
  CHECK_FALSE(has(text, "more"));
}

TEST_CASE("bars are drawn over and gone at the end; colour only where asked for") {
  const std::string text = written(ProgressDisplay::Mode::bars, false);
  CHECK(has(text, "baseline           [------------------------] 0 %"));
  CHECK(has(text, "0/2 designs"));
  CHECK(has(text, "\033[2A\033[J"));
  CHECK_FALSE(has(text, "\033[32m"));
  CHECK(has(written(ProgressDisplay::Mode::bars, true), "\033[32mok, mean load 969.0 kN\033[0m"));
}

TEST_CASE("a run on its own says step, speed, load and energy balance on a line of 80 columns") {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  {
    ProgressDisplay display(file, ProgressDisplay::Mode::bars, false);
    StudyPlan plan;
    plan.designs.resize(1);
    display.on_planned(plan);
    Progress p = at(12345, 52335);
    p.ns_per_bond = 0.4132;
    p.hull_work = 58.73;
    p.balance_error = -0.47;
    display.on_progress("baseline", p);
  }
  const std::string text = contents(file);
  CHECK(has(text, "[##------] 23 %  eta "));
  CHECK(has(text, "12345/52335  0.413 ns/bond  35.2 N  58.7 J -0.8 %\n"));
  CHECK(columns(text.substr(0, text.find('\n'))) < 80);
}

TEST_CASE("text is measured and cut in characters, not in bytes") {
  CHECK(columns("Kapit\u00e4n") == 7);
  CHECK(cut("Kapit\u00e4n", 6) == "Kapit\u00e4");
  CHECK(cut("abc", 5) == "abc");
  CHECK(text_table({{"a", "value"}, {"l\u00e4nger", "1"}}) == "a       value\nl\u00e4nger      1\n");
}

TEST_CASE("times and numbers for people") {
  CHECK(clock_time(42.4) == "0:42");
  CHECK(clock_time(3723) == "1:02:03");
  CHECK(clock_time(NAN) == "--:--");
  CHECK(decimals(1.25, 1) == "1.2");
  CHECK(decimals(INFINITY, 1) == "-");
  CHECK(decimals(-0.01, 1) == "0.0");
}
