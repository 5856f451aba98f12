// One design from its document to its files, with the real hull and the real solver on a coarse, short run.
#include "study/evaluate/evaluate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "base/json_fields.h"
#include "formula/lindqvist.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/spec/case_hull.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_constraints.h"
#include "tests/support/fake_study.h"
#include "tests/support/main.h"

using namespace icebow;

namespace {

constexpr const char* coarse =
    R"({"solver": {"layers": 1}, "output": {"pictures": 1}, "ice": {"thickness_m": 1.2},
  "sheet": {"length_m": 40, "width_m": 50}, "operation": {"speed_kn": 6, "advance_m": 6, "steady_from_m": 2}})";

Design design_of(const std::string& patch) {
  Json document = fake_document(coarse);
  document.merge_patch(Json::parse(patch));
  return read_design("one", document, {{"/bow/stem_deg", 25.0}});
}

Evaluation evaluated(const std::string& patch, const EvaluateOptions& options = {}) {
  return evaluate(test_world(), design_of(patch), options);
}

void check_has(const Json& json, const std::vector<std::string>& pointers) {
  for (const std::string& pointer : pointers) {
    CAPTURE(pointer);
    CHECK(json.contains(Json::json_pointer(pointer)));
  }
}

bool exists(const std::string& path) {
  return std::filesystem::exists(path);
}

}  // namespace

TEST_CASE("a design becomes a result with all its files, the same on every rank") {
  const TemporaryDirectory own;
  EvaluateOptions options;
  options.directory = test_world().broadcast(own / "designs/one");
  int calls = 0;
  options.on_progress = [&](const Progress&) { ++calls; };
  const Evaluation e = evaluated("{}", options);
  INFO(e.reason);
  REQUIRE(e.status == EvaluationStatus::ok);
  CHECK(json_text(to_json(e)) == test_world().broadcast(json_text(to_json(e))));
  CHECK(e.key == evaluation_key(design_of("{}").given.value(), {true, true}));
  const Json& r = e.result;
  CHECK(r.at("metrics").at("full_scale").at("mean_load_N").get<double>() > 0.0);
  CHECK(r.at("metrics").at("full_scale").at("mean_load_N").get<double>() ==
        Approx(25.0 * 25.0 * 25.0 * r.at("metrics").at("mean_load_N").get<double>()));
  CHECK(r.at("lindqvist").at("breaking_N").get<double>() > 0.0);
  CHECK(r.at("hull").at("feasible") == true);
  CHECK(r.at("parameters").at("/bow/stem_deg") == 25.0);
  CHECK(r.at("simulation").at("nz") == 1);
  check_has(r, result_key::all());
  check_has(part_at(r, result_key::pictures).at(0), {result_key::picture_file, result_key::picture_advance});
  CHECK(r.at("simulation").at("lambda") == 25);
  CHECK(r.at("provenance").at("ranks") == test_world().size());
  if (test_world().is_root()) {
    CHECK(read_json_file(options.directory + "/result.json") == r);
    for (const char* file : {"history", "lines_plan", "hull"}) {
      CHECK(exists(options.directory + "/" + r.at("files").at(file).get<std::string>()));
    }
    REQUIRE(r.at("files").at("pictures").size() == 1);
    CHECK(exists(options.directory + "/" + r.at("files").at("pictures")[0].at("file").get<std::string>()));
    std::istringstream history(read_text_file(options.directory + "/history.csv"));
    std::string header, row;
    std::getline(history, header);
    CHECK(header ==
          "time_s,advance_m,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm,broken_bonds,contacts,kinetic_energy_J,"
          "potential_J,hull_work_J,contact_loss_J,elastic_J,fracture_J,balance_error_J,water_loss_J,floe_"
          "loss_J,edge_loss_J");
    CHECK(std::getline(history, row));
    CHECK(std::count(row.begin(), row.end(), ',') == 19);
    CHECK(r.at("simulation").at("ended") == "advance reached");
    CHECK(r.at("profile").at(0).at("phase") == "drift");
    CHECK(r.at("profile").at(0).at("share").get<double>() > 0.0);
  }
}

TEST_CASE("keys that few results have are where they are looked for") {
  BreakingProcess process;
  process.cracks.list.emplace_back();
  check_has(part_at({{"process", process_json(process)}}, result_key::crack_list).at(0),
            {result_key::crack_kind, result_key::crack_opened, result_key::crack_length});
  check_has({{"cycle", {{"same_way", same_way_json({})}}}},
            {result_key::cycle_same_way_load, result_key::cycle_same_way_ci95});
}

TEST_CASE("an impossible bow is infeasible, with margins and without a simulation") {
  const Evaluation e = evaluated(R"({"bow": {"bow_length_m": 12, "waterline_deg": 12}})");
  CHECK(e.status == EvaluationStatus::infeasible);
  CHECK_FALSE(e.reason.empty());
  CHECK(e.result.at("hull").at("margins").size() >= 1);
  CHECK(e.result.at("simulation").is_null());
  CHECK(e.result.at("metrics").is_null());
}

TEST_CASE("formula alone: no simulation, still a result") {
  const Evaluation e = evaluated(R"({"evaluators": ["lindqvist"]})");
  CHECK(e.status == EvaluationStatus::ok);
  CHECK(e.result.at("simulation").is_null());
  CHECK(e.result.at("lindqvist").at("valid") == true);
  CHECK(e.result.at("hull").at("feasible") == true);
  CHECK(e.result.at("hull").at("requested_deg").at("stem").is_number());
  CHECK(e.result.at("hull").at("mesh").is_null());  // nothing is measured where there is no mesh
  CHECK(e.result.at("hull").at("measured_deg").at("stem").is_null());
}

TEST_CASE("what cannot be simulated is a failed design that says why") {
  const Evaluation narrow = evaluated(R"({"sheet": {"width_m": 10}})");
  CHECK(narrow.status == EvaluationStatus::failed);
  CHECK_FALSE(narrow.reason.empty());
  CHECK(narrow.result.at("metrics").is_null());
  const Evaluation unreadable = evaluated(R"({"bow": {"stem_deg": "steep"}})");
  CHECK(unreadable.status == EvaluationStatus::failed);
  CHECK_THAT(unreadable.reason, Catch::Contains("/bow/stem_deg"));
}

TEST_CASE("an interrupted design is neither good nor bad, and leaves no result file") {
  const TemporaryDirectory own;
  EvaluateOptions options;
  options.directory = test_world().broadcast(own / "one");
  options.stop = [] { return true; };
  const char* longer =
      R"({"sheet": {"length_m": 90}, "operation": {"advance_m": 50}})";  // stop is asked now and then
  CHECK(evaluated(longer, options).status == EvaluationStatus::running);
  if (test_world().is_root()) CHECK_FALSE(exists(options.directory + "/result.json"));
}

TEST_CASE("an interrupted design goes on from its checkpoint, another design of that name does not") {
  const TemporaryDirectory own;
  EvaluateOptions options;
  options.directory = test_world().broadcast(own / "one");
  int resumed = 0;
  options.on_resume = [&](std::int64_t) { ++resumed; };
  const char* longer =
      R"({"sheet": {"length_m": 90}, "operation": {"advance_m": 50}, "solver": {"time_step_fraction": 0.2}})";
  for (int turn = 0; turn < 2; ++turn) {
    options.stop = [seen = 0]() mutable { return ++seen > 1; };  // the first is asked before the simulation
    REQUIRE(evaluated(longer, options).status == EvaluationStatus::running);
  }
  options.stop = nullptr;
  if (test_world().is_root()) CHECK(resumed == 1);
  REQUIRE(evaluated("{}", options).status == EvaluationStatus::ok);
  if (test_world().is_root()) CHECK(resumed == 1);
  if (test_world().is_root()) CHECK_FALSE(exists(options.directory + "/checkpoint.h5"));
}

TEST_CASE("a design is simulated in each scenario, and goes on behind those that are over") {
  const TemporaryDirectory own;
  EvaluateOptions options;
  options.directory = test_world().broadcast(own / "one");
  const auto kept = [&] {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(options.directory))
      files += is_kept_scenario(entry.path().filename().string()) ? 1 : 0;
    return files;
  };
  const char* scenarios =
      R"({"scenarios": [{"name": "slow", "weight": 3, "set": {"operation": {"speed_kn": 5}}},
                                            {"name": "fast", "set": {"operation": {"speed_kn": 6}}}]})";
  options.stop = [&] { return kept() > 0; };
  REQUIRE(evaluated(scenarios, options).status == EvaluationStatus::running);
  test_world().barrier();
  const std::string history = options.directory + "/history.csv";
  CHECK(kept() == 1);
  const auto written = std::filesystem::last_write_time(history);
  options.stop = nullptr;
  const Evaluation both = evaluated(scenarios, options);
  INFO(both.reason);
  REQUIRE(both.status == EvaluationStatus::ok);
  test_world().barrier();
  CHECK(std::filesystem::last_write_time(history) == written);  // the first is not sailed again
  CHECK(kept() == 0);
  CHECK_FALSE(exists(options.directory + "/checkpoint.h5"));

  const Evaluation slow = evaluated(R"({"operation": {"speed_kn": 5}})"), fast = evaluated("{}");
  const auto at = [](const Evaluation& e, const char* pointer) { return number_at(e.result, pointer); };
  CHECK(at(both, result_key::mean_load) ==
        Approx(0.75 * at(slow, result_key::mean_load) + 0.25 * at(fast, result_key::mean_load)));
  CHECK(at(both, result_key::mean_load_ci95) ==
        Approx(std::hypot(0.75 * at(slow, result_key::mean_load_ci95),
                          0.25 * at(fast, result_key::mean_load_ci95))));
  const std::vector<ScenarioLoad> loads = scenario_loads(both.result);
  REQUIRE(loads.size() == 2);
  CHECK(loads[0].name == "slow");
  CHECK(loads[0].mean == at(slow, result_key::mean_load));
  CHECK(loads[1].mean == at(fast, result_key::mean_load));
  CHECK(loads[1].ci95 == at(fast, result_key::mean_load_ci95));
}

TEST_CASE("a directory that cannot be written is the machine's fault, on every rank") {
  EvaluateOptions options;
  options.directory = "/proc/no/such/place";
  CHECK_THROWS_AS(evaluated("{}", options), RuntimeError);
}

// Pointers of all numbers of a part of a result, also of those that are not known.
void list_numbers(const Json& part, const std::string& at, std::vector<std::string>& pointers) {
  if (part.is_number() || part.is_null()) pointers.push_back(at);
  if (!part.is_object()) return;
  for (const auto& item : part.items()) list_numbers(item.value(), at + "/" + item.key(), pointers);
}

TEST_CASE("the numbers that a study file may name are those of a result") {
  const Json r =
      evaluated(R"({"evaluators": ["lindqvist", "cycle"], "cycle": {"voyage_m": 40, "voyages": 2}})").result;
  std::vector<std::string> there;
  for (const char* part : {"/hull/margins", "/hydrostatics", "/lindqvist", "/cycle", "/metrics"})
    list_numbers(part_at(r, part), part, there);
  StudySpec spec;
  spec.use_lindqvist = spec.use_cycle = true;
  for (const std::string& pointer : there) {
    CAPTURE(pointer);
    const bool list = part_at(r, pointer).is_null() && pointer.find("/list") != std::string::npos;
    CHECK((list || lacking_number(spec, pointer).empty()));
  }
  for (const std::string& pointer : numbers_of_results()) {
    CAPTURE(pointer);
    const bool of_some_families = pointer.rfind("/hull/margins/", 0) == 0;
    const bool of_confirmed_studies = pointer.rfind("/cycle/same_way/", 0) == 0;
    CHECK((of_some_families || of_confirmed_studies ||
           std::find(there.begin(), there.end(), pointer) != there.end()));
  }
}

TEST_CASE("the breaking cycle alone has the fields of a simulation, the same on every rank") {
  const TemporaryDirectory own;
  EvaluateOptions options;
  options.directory = test_world().broadcast(own / "designs/one");
  const char* quick = R"({"evaluators": ["lindqvist", "cycle"], "ice": {"flexural_strength_kPa": 863},
    "cycle": {"voyage_m": 40, "voyages": 2}})";
  const Evaluation e = evaluated(quick, options);
  INFO(e.reason);
  REQUIRE(e.status == EvaluationStatus::ok);
  CHECK(json_text(to_json(e)) == test_world().broadcast(json_text(to_json(e))));
  const Json &r = e.result, &cycle = r.at("cycle");
  check_has(r, {std::begin(result_key::of_every_cycle), std::end(result_key::of_every_cycle)});
  const double mean = cycle.at("mean_load_N").get<double>();
  double parts = 0.0;
  for (const char* part : {"crushing_N", "bending_N", "friction_N", "submersion_N", "water_N"})
    parts += cycle.at(part).get<double>();
  CHECK(parts == Approx(mean).epsilon(1e-9));  // rounding of a sum
  CHECK(r.at("metrics").at("full_scale").at("mean_load_N").get<double>() == mean);
  CHECK(r.at("metrics").at("mean_load_N").get<double>() == mean);  // it is run at full scale
  CHECK(r.at("metrics") == cycle.at("metrics"));
  CHECK(r.at("process").at("breaking_length").at("cracks").get<int>() > 0);
  CHECK(r.at("simulation").is_null());
  if (test_world().is_root()) {
    CHECK(exists(options.directory + "/voyage.svg"));
    CHECK(exists(options.directory + "/history.csv"));
  }
}

TEST_CASE("submersion is left out, or by the formula, where the study says so") {
  const auto load = [](const std::string& more) {
    const Evaluation e =
        evaluated(R"({"evaluators": ["cycle"], "cycle": {"voyage_m": 30, "voyages": 1, )" + more + "}}");
    REQUIRE(e.status == EvaluationStatus::ok);
    return e.result.at("cycle");
  };
  const Json alone = load(R"("submersion": false)"), formula = load(R"("submersion_by": "lindqvist")");
  CHECK(alone.at("submersion_N") == 0.0);
  const LindqvistResult lindqvist_says = lindqvist(lindqvist_inputs(design_of("{}").given.value()));
  CHECK(formula.at("mean_load_N").get<double>() - alone.at("mean_load_N").get<double>() ==
        Approx(lindqvist_says.total - lindqvist_says.breaking));
}

TEST_CASE("a hull that does not reach the ice is a failed design with one sentence") {
  const Evaluation e =
      evaluated(R"({"evaluators": ["cycle"], "ice": {"thickness_m": 10}, "bow": {"draft_m": 5}})");
  CHECK(e.status == EvaluationStatus::failed);
  CHECK(e.reason.find("the hull does not go through the ice") == 0);
}

TEST_CASE(
    "the cycle over a simulation's way: less while the bow enters, and under a part of the hull alone") {
  if (test_world().size() > 1) return;
  Case c = fake_study(R"({"evaluators": ["cycle"]})").baseline;
  const QuadMesh hull = make_hull(c).mesh;
  cycle::BreakingRule rule = c.cycle.rule;
  const auto over = [&](double from, double to, double under_hull) {
    c.steady_from = from, c.advance = to;
    return run_same_way(c, hull, rule, under_hull);
  };
  const double whole = run_cycle(c, hull, rule).mean, under = 0.2e6;
  const SameWay entering = over(2.0, 15.0, under), late = over(60.0, 200.0, under);
  INFO("whole voyage " << whole << " N, entering " << entering.mean << " +- " << entering.ci95 << ", later "
                       << late.mean << " +- " << late.ci95);
  CHECK(entering.mean + entering.ci95 < 0.6 * late.mean);
  CHECK(late.ci95 < 0.2 * late.mean);
  // What the hull bears under itself: on 2 to 15 m the ice has reached 8.5 of 147.2 m of it in the mean.
  CHECK(over(2.0, 15.0, 2.0 * under).mean - entering.mean == Approx(under * 8.5 / 147.2));
  c.sheet.window_ahead = 20.0, c.sheet.length = 56.0;  // 36 m of ice astern of the stem at most
  CHECK(over(60.0, 200.0, 2.0 * under).mean - over(60.0, 200.0, under).mean == Approx(under * 36.0 / 147.2));
}
