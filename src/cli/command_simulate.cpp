#include <filesystem>
#include <iostream>

#include "base/errors.h"
#include "cli/commands.h"
#include "cli/process_text.h"
#include "cli/progress.h"
#include "cli/stop_signal.h"
#include "cli/study_choice.h"
#include "cli/text_table.h"
#include "study/evaluate/evaluate.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

constexpr int usual_snapshots = 10;

// One run is looked at: it has snapshots, and is simulated whatever the study evaluates.
Design to_simulate(const ChosenDesign& chosen) {
  Design design = chosen.design;
  if (design.given->snapshots == 0) design.given->snapshots = usual_snapshots;
  design.asked = Evaluators{true, true};
  return design;
}

EvaluateOptions options_for(const Arguments& arguments, const std::string& design, ProgressDisplay& display) {
  EvaluateOptions options;
  options.directory = arguments.value("--out");
  options.on_progress = [&display, design](const Progress& p) { display.on_progress(design, p); };
  options.stop = StopSignal::raised;
  options.resume = arguments.has("--restart") ? Resume::never : Resume::always;
  options.on_resume = [&display, options](std::int64_t step) {
    display.announce("continues at step " + std::to_string(step) + " from " + options.directory + "/" +
                     checkpoint_name + " (--restart starts anew)");
  };
  return options;
}

std::string kilonewtons(const Json& loads, const char* key) {
  const auto value = loads.find(key);
  return value != loads.end() && value->is_number() ? decimals(value->get<double>() / 1e3, 1) : "-";
}

std::string bias_sentence(const Json& result) {
  const Json::json_pointer at(result_key::bias_sentence);
  return result.contains(at) ? result.at(at).get<std::string>() + "\n" : "";
}

std::string for_people(const Evaluation& e, const std::string& directory) {
  std::string text = e.name + ": " + to_string(e.status) + ", results in " + directory + "\n";
  const Json::json_pointer at("/metrics/full_scale");
  if (!e.result.contains(at)) return text;
  const Json& loads = e.result.at(at);
  const Json::json_pointer ice("/simulation/ice/sentence");
  const std::string ice_sentence = e.result.contains(ice) ? e.result.at(ice).get<std::string>() + "\n" : "";
  return text + ice_sentence + "full scale: mean load " + kilonewtons(loads, "mean_load_N") + " \u00b1 " +
         kilonewtons(loads, "mean_load_ci95_N") + " kN (95 %), maximum " + kilonewtons(loads, "max_load_N") +
         " kN\n" + process_text(e.result) + bias_sentence(e.result);
}

// Where the time went; on stderr, as progress is, so that --json stays JSON.
std::string profile_table(const Json& profile) {
  std::vector<std::vector<std::string>> rows = {{"phase", "ms/step", "share", "slowest rank ms/step"}};
  double total = 0.0;
  for (const Json& p : profile) {
    const auto value = [&](const char* key) { return p.at(key).is_number() ? p.at(key).get<double>() : 0.0; };
    total += value("ms_per_step");
    rows.push_back({p.at("phase").get<std::string>(), decimals(value("ms_per_step"), 4),
                    decimals(100.0 * value("share"), 1) + " %", decimals(value("max_ms_per_step"), 4)});
  }
  rows.push_back({"step", decimals(total, 4), "", ""});
  return text_table(rows);
}

std::string linear_share_line(const Json& simulation) {
  if (!simulation.contains("linear_share")) return "";
  return decimals(100.0 * simulation.at("linear_share").get<double>(), 0) +
         " % of the ice followed the linear law\n";
}

int report(const Evaluation& e, const Arguments& arguments) {
  if (arguments.has("--profile") && e.result.contains("profile") && e.result.at("profile").is_array())
    std::cerr << profile_table(e.result.at("profile")) << linear_share_line(e.result.at("simulation"));
  if (e.status == EvaluationStatus::running) {
    std::cerr << "icebow simulate: interrupted; the same command continues the run\n";
    return exit_code::interrupted;
  }
  if (arguments.has("--json")) {
    std::cout << json_text(e.result, 2) << "\n";
  } else {
    std::cout << for_people(e, arguments.value("--out"));
  }
  if (e.status == EvaluationStatus::ok) return exit_code::ok;
  std::cerr << e.name << ": " << to_string(e.status) << ": " << e.reason << "\n";
  return exit_code::failure;
}

}  // namespace

int run_simulate(const Communicator& comm, const Arguments& arguments) {
  const StudySpec spec = load_study(comm, arguments);
  const Design design = to_simulate(choose_design(comm, spec, arguments));
  const StopSignal signals;
  Evaluation e;
  {
    ProgressDisplay display;
    StudyPlan plan;
    plan.designs.resize(1);
    display.on_planned(plan);
    if (comm.is_root()) display.on_started(design);
    e = evaluate(comm, design, options_for(arguments, design.name, display));
  }
  return comm.is_root() ? report(e, arguments) : exit_code::ok;
}

}  // namespace icebow
