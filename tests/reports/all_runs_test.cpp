// A study whose designs were run several times: every number is of all runs, or says that it is not.
#include "reports/content/all_runs.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "base/json.h"
#include "reports/content/conditions.h"
#include "reports/html/html_report.h"
#include "reports/tables/table_report.h"
#include "study/store/design_files.h"
#include "study/store/store.h"
#include "tests/support/scratch.h"

namespace icebow {
namespace {

Evaluation run(const std::string& name, double mean, double peak, double quantile) {
  Evaluation e;
  e.key = e.name = name;
  e.status = EvaluationStatus::ok;
  e.wall_seconds = 2.0;
  const auto loads = [&](double newtons) {
    return Json{{"mean_load_N", mean * newtons}, {"mean_load_ci95_N", 30.0 * newtons},
                {"max_load_N", peak * newtons},  {"q95_load_N", quantile * newtons},
                {"std_load_N", 5.0 * newtons},   {"vertical_mean_N", mean * newtons}};
  };
  Json metrics = loads(1.0);
  metrics.update({{"effective_samples", 12.0}, {"lambda", 10.0}, {"full_scale", loads(1e3)}});
  e.result = {{"metrics", metrics},
              {"simulation", {{"lambda", 10.0}, {"nz", 3}, {"wall_s", 2.0}}},
              {"process", {{"cracks", Json::object()}}}};
  return e;
}

void write_study(const std::string& directory, const std::vector<Evaluation>& runs) {
  Store store = Store::open(directory + "/results.sqlite");
  store.set_fact("rank_by", "mean_load");
  store.set_fact("state", "finished");
  for (const Evaluation& e : runs) store.put(e);
}

std::vector<Evaluation> six_runs() {
  return {run("a", 100, 300, 210), run("a#2", 104, 340, 216), run("a#3", 108, 320, 222),
          run("b", 200, 500, 400), run("b#2", 206, 520, 403), run("b#3", 212, 510, 409)};
}

std::string html_of(const Scratch& study) {
  write_html_report(study.path(), study.path() + "/report.html");
  return read_text_file(study.path() + "/report.html");
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("of repeated runs the table has their mean, their highest peak and all their samples") {
  const Scratch study("runs");
  write_study(study.path(), six_runs());
  const std::string csv = ranking_csv(read_study_results(study.path()));
  // Student's t of two degrees of freedom, of means 4 N apart at model scale.
  const double half = 4.302652729911275 * 4.0 / std::sqrt(3.0);
  INFO(csv);
  CHECK(holds(csv, "\n1,a,ok,,,,,104000,"));
  const std::size_t at = csv.find("\n1,a,");
  const std::string row = csv.substr(at + 1, csv.find('\n', at + 1) - at - 1);
  std::vector<std::string> fields(1);
  for (const char c : row)
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  CHECK(std::stod(fields.at(8)) == Approx(1e3 * half));
  CHECK(fields.at(9) == "340000");   // the highest of all peaks, of the second run
  CHECK(fields.at(10) == "216000");  // the mean of the quantiles
  CHECK(fields.at(12) == "104");     // at model scale likewise of all
  CHECK(std::stod(fields.at(13)) == Approx(half));
  CHECK(holds(csv, ",36,"));  // samples: twelve a run
}

TEST_CASE("a page of repeats counts its runs, and says which parts are of the first alone") {
  const Scratch study("runs");
  write_study(study.path(), six_runs());
  const std::string html = html_of(study);
  CHECK(holds(html, "2 designs ranked, 3 runs each"));
  CHECK(holds(html, "6 runs of 2 designs: 6 ok"));
  CHECK(holds(html, "Mean of 3 runs, by their scatter"));
  CHECK(holds(html, "What follows is of the first of 3 runs."));
  CHECK(holds(html, "\"max_N\":340000.0"));
  CHECK(holds(html, "\"q95_N\":216000.0"));
}

TEST_CASE("a run that failed takes nothing from its design but itself") {
  std::vector<Evaluation> runs = six_runs();
  runs[0].status = EvaluationStatus::failed;
  runs[0].reason = "unstable at step 12";
  const Scratch study("runs");
  write_study(study.path(), runs);
  const StudyResults results = read_study_results(study.path());
  REQUIRE(results.ranked() == 2);
  CHECK(results.ranking.rows[0].evaluation.name == "a");
  CHECK(results.ranking.rows[0].mean_load == Approx(106e3));
  const std::string html = html_of(study);
  CHECK(holds(html, "2 designs ranked, 2 to 3 runs each</p>"));
  CHECK(holds(html, "Run 1 of a failed, and its mean is of the other runs: unstable at step 12."));
  CHECK(holds(html, "6 runs of 2 designs: 5 ok, 1 failed"));
}

TEST_CASE("a drift of repeated runs is that of all of them") {
  std::vector<Evaluation> runs = six_runs();
  const Scratch study("runs");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].result["metrics"]["full_scale"].update({{"steady_from_m", 1.0}, {"steady_to_m", 9.0}});
    runs[k].result["files"] = {{"history", "history.csv"}};
    // The second half of design a's records is 1.5, 1.6 or 1.7 times the first; b's go up and down.
    const double step = k < 3 ? 0.5 + 0.1 * static_cast<double>(k) : 0.2 * (static_cast<double>(k) - 4.0);
    std::string csv = "advance_m,Fx_N\n";
    for (int i = 0; i < 90; ++i)  // model scale: 0 to 0.9 m
      csv += std::to_string(0.01 * i + 0.005) + "," + std::to_string(-100.0 * (i < 50 ? 1.0 : 1.0 + step)) +
             "\n";
    const std::string files = design_directory(study.path(), runs[k].name);
    std::filesystem::create_directories(files);
    write_text_file(files + "/history.csv", csv);
  }
  write_study(study.path(), runs);
  const std::string html = html_of(study);
  // 60 % and Student's t of two degrees of freedom, 4.30, times 10 % over the root of three.
  CHECK(
      holds(html,
            "The load of a drifts: the second half of its steady part is 60\u00a0\u00b1\u00a025\u00a0% above "
            "the first over 3 runs"));
  CHECK_FALSE(holds(html, "The load of b drifts"));
}

TEST_CASE("the seeds of repeated runs are told, and that the first one's ice may start at rest") {
  StudyResults study;
  study.document = Json::parse(R"({
    "icebow_study": 1, "name": "Repeats", "purpose": "p", "scale": 25, "repeats": 3,
    "bow": {"family": "straight_parallel_buttocks", "length_m": 147.2, "beam_m": 23.0, "draft_m": 8.0,
            "depth_m": 13.5, "bow_length_m": 32.5, "stem_deg": 24.35, "waterline_deg": 22.0, "buttock_deg": 28.0,
            "flare_deg": 33.0},
    "ice": {"thickness_m": 2.0, "flexural_strength_kPa": 500}, "sheet": {"length_m": 40, "width_m": 30},
    "operation": {"speed_kn": 6, "advance_m": 8}, "solver": {"layers": 2}})");
  study.ranking = rank_designs(six_runs(), "mean_load");
  const auto seeds = [&] {
    for (const Fact& fact : conditions(study).simulated)
      if (fact.label == "Seeds of the ice") return fact.value;
    return std::string();
  };
  CHECK(seeds() == "none in the first run of a design, whose ice starts at rest; 1 to 2 in the others");
  study.document["solver"]["seed"] = 7;
  CHECK(seeds() == "7 to 9");
}

TEST_CASE("one run is a run like any other") {
  const Scratch study("runs");
  write_study(study.path(), {run("a", 100, 300, 210), run("b", 200, 500, 400)});
  const StudyResults results = read_study_results(study.path());
  CHECK(runs_of(results, results.ranking.rows[0].evaluation) == 1);
  const std::string html = html_of(study);
  CHECK(holds(html, "2 evaluated: 2 ok"));
  CHECK_FALSE(holds(html, "runs each"));
  CHECK_FALSE(holds(html, "What follows is of the first"));
}

}  // namespace icebow
