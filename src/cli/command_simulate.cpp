#include <cmath>
#include <filesystem>
#include <iostream>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/stop_signal.h"
#include "cli/commands.h"
#include "cli/process_text.h"
#include "cli/progress.h"
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
  options.checkpoint_now = StopSignal::checkpoint_asked;
  options.resume = arguments.has("--restart") ? Resume::never : Resume::always;
  options.on_resume = [&display, options](std::int64_t step) {
    display.announce("continues at step " + std::to_string(step) + " from " + options.directory + "/" +
                     checkpoint_name + " (--restart starts anew)");
  };
  return options;
}

std::string kilonewtons(const Json& result, const char* load) {
  const double newtons = number_at(result, load);
  return std::isfinite(newtons) ? decimals(newtons / 1e3, 1) : "-";
}

// A line of its own, where the result says anything.
std::string line_of(const Json& result, const char* sentence) {
  const std::string words = text_at(result, sentence);
  return words.empty() ? "" : words + "\n";
}

std::string for_people(const Evaluation& e, const std::string& directory) {
  const Json& result = e.result;
  const std::string text = e.name + ": " + to_string(e.status) + ", results in " + directory + "\n";
  if (!part_at(result, result_key::full_scale).is_object()) return text;
  return text + line_of(result, result_key::simulated_ice_sentence) + "full scale: mean load " +
         kilonewtons(result, result_key::mean_load) + " \u00b1 " +
         kilonewtons(result, result_key::mean_load_ci95) + " kN (95 %), maximum " +
         kilonewtons(result, result_key::max_load) + " kN\n" + process_text(result) +
         line_of(result, result_key::bias_sentence);
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
