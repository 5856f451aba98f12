#include "study/evaluate/evaluate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/errors.h"
#include "base/printable.h"
#include "formula/lindqvist.h"
#include "geometry/mesh_slice.h"
#include "hullgen/drawing/lines_plan.h"
#include "hullgen/mesh/mesh_io.h"
#include "solver/run/checkpoint.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/history_csv.h"
#include "study/evaluate/patch_tests.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/provenance.h"
#include "study/evaluate/resolution_bias.h"
#include "study/evaluate/result_json.h"
#include "study/evaluate/voyage_picture.h"
#include "study/spec/case_hull.h"
#include "study/spec/spec_case.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

// The root writes, every rank learns whether it could: a full disk is not to leave the others waiting.
template <class Write>
void on_root(const Communicator& comm, const Write& write) {
  std::string error;
  if (comm.is_root()) {
    try {
      write();
    } catch (const std::exception& e) {
      error = e.what();
    }
  }
  error = comm.broadcast(error);
  if (!error.empty()) throw RuntimeError(error);
}

// One design on its way from document to result.
class DesignRun {
 public:
  DesignRun(const Communicator& comm, const Design& design, const EvaluateOptions& options)
      : comm_(comm), design_(design), options_(options) {
    e_.name = design.name;
    e_.parameters = design.parameters;
    e_.result = {{"files", Json::object()}};
  }

  Evaluation run() {
    const auto begin = Clock::now();
    if (writes()) on_root(comm_, [&] { std::filesystem::create_directories(options_.directory); });
    evaluate();
    e_.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    describe();
    if (writes() && e_.status != EvaluationStatus::running) {
      on_root(comm_, [&] {
        write_text_file(path("result.json"), json_text(e_.result, 2) + "\n");
        if (!options_.keep_checkpoint) remove_checkpoint_in(options_.directory);
      });
    }
    return e_;
  }

 private:
  void evaluate();
  void measure_hull();
  void apply_formula();
  void run_voyages();
  void draw_voyage(const CycleOutcome& outcome);
  void run_simulation();
  RunResult simulated();
  void take(const RunResult& run);
  void judge();
  void describe();
  void write_hull();

  bool writes() const { return !options_.directory.empty(); }
  std::string path(const std::string& file) const {
    return (std::filesystem::path(options_.directory) / file).string();
  }
  void end(EvaluationStatus status, const std::string& reason) {
    e_.status = status;
    e_.reason = reason;
    ended_ = true;
  }

  const Communicator& comm_;
  const Design& design_;
  const EvaluateOptions& options_;
  Evaluation e_;
  bool ended_ = false;  // infeasible, failed or interrupted: the rest is left out
  Case case_;
  Hull hull_;
  IceMaterial simulated_ice_;  // model scale
  Json ice_;                   // what it is: simulated_ice_json()
  std::vector<std::string> notes_;
};

void DesignRun::evaluate() {
  std::string error;
  try {
    case_ = read_case(design_.document, design_.name);
  } catch (const InputError& e) {
    error = e.what();
  }
  error = first_trouble(comm_, error);
  if (!error.empty()) return end(EvaluationStatus::failed, error);
  e_.key = evaluation_key(case_, design_.document);
  measure_hull();
  if (!ended_ && asks_for(design_.document, "lindqvist")) apply_formula();
  if (!ended_ && asks_for(design_.document, "cycle")) run_voyages();
  const bool stop = comm_.is_root() && options_.stop && options_.stop();  // a hull takes a while
  if (!ended_ && comm_.any(stop)) end(EvaluationStatus::running, "interrupted");
  if (!ended_ && asks_for(design_.document, "peridynamics")) run_simulation();
  if (!ended_) judge();
}

void DesignRun::measure_hull() {
  const BowParameters& bow = case_.bow;
  hull_ = make_hull(case_);
  e_.result["ship"] = {{"L_m", bow.L}, {"B_m", bow.B}, {"T_m", bow.T}};
  e_.result["hull"] = hull_json(hull_);
  if (case_.own.given()) e_.result["hull"]["imported"] = imported_json(case_.own);
  if (hull_.status != HullStatus::ok) return end(EvaluationStatus::infeasible, hull_.reason);
  if (writes()) on_root(comm_, [&] { write_hull(); });
}

void DesignRun::write_hull() {
  write_mesh(path("hull.obj"), hull_.mesh);
  write_text_file(path("lines.svg"), lines_plan_svg(hull_, case_.bow, design_.name));
  e_.result["files"]["hull"] = "hull.obj";
  e_.result["files"]["lines_plan"] = "lines.svg";
}

void DesignRun::apply_formula() {
  const LindqvistInputs inputs = lindqvist_inputs(case_);
  e_.result["lindqvist"] = lindqvist_json(lindqvist(inputs), inputs);
}

// Where nothing finer is asked for, its record stands where a simulation's would.
void DesignRun::run_voyages() {
  cycle::BreakingRule rule;
  try {
    rule = cycle_rule(comm_, case_);
  } catch (const InputError& error) {
    return end(EvaluationStatus::failed, error.what());
  }
  const CycleOutcome outcome = run_cycle(case_, hull_.mesh, rule);
  e_.result["cycle"] = cycle_json(outcome, case_, rule);
  if (!outcome.reason.empty()) return;
  const Json metrics = cycle_metrics_json(outcome), process = process_json(outcome.run.process);
  e_.result["cycle"]["metrics"] = metrics;
  e_.result["cycle"]["process"] = process;
  const bool finest = !asks_for(design_.document, "peridynamics");
  if (finest) e_.result["metrics"] = metrics, e_.result["process"] = process;
  if (!writes()) return;
  on_root(comm_, [&] {
    draw_voyage(outcome);
    if (!finest) return;
    write_text_file(path("history.csv"), history_csv(outcome.run.history));
    e_.result["files"]["history"] = "history.csv";
  });
}

void DesignRun::draw_voyage(const CycleOutcome& outcome) {
  const auto lines = slice(hull_.mesh, 2, 0.0);
  const auto longest = std::max_element(
      lines.begin(), lines.end(), [](const Polyline& a, const Polyline& b) { return a.size() < b.size(); });
  const double shown = 5.0 * case_.bow.B;
  write_text_file(path("voyage.svg"),
                  voyage_svg(outcome.first_voyage, longest == lines.end() ? Polyline() : *longest,
                             outcome.submersion + outcome.water, shown, design_.name + ": breaking cycle"));
  e_.result["files"]["voyage"] = "voyage.svg";
}

void DesignRun::run_simulation() {
  const RunResult run = simulated();
  if (ended_) return;
  take(run);
  if (writes()) {
    on_root(comm_, [&] {
      write_text_file(path("history.csv"), history_csv(run.history));
      e_.result["files"]["history"] = "history.csv";
    });
  }
  if (run.status == RunStatus::interrupted) end(EvaluationStatus::running, "interrupted");
  if (run.status == RunStatus::failed) end(EvaluationStatus::failed, run.reason);
}

// A scenario that cannot be run is the design's fault, and so is one too large for the memory; a full disk is
// not.
RunResult DesignRun::simulated() {
  RunOptions run_options;
  run_options.directory = options_.directory;
  run_options.snapshots = case_.snapshots;
  run_options.snapshot_format = case_.snapshot_format;
  run_options.pictures = case_.pictures;
  run_options.seed = case_.seed;
  run_options.on_progress = options_.on_progress;
  run_options.stop = options_.stop;
  if (writes()) run_options.checkpoint_file = path(checkpoint_name);
  run_options.keep_checkpoint = true;
  run_options.checkpoint_every_s = options_.checkpoint_every_s;
  run_options.resume = options_.resume;
  run_options.on_resume = options_.on_resume;
  run_options.on_note = [this](const std::string& words) {
    notes_.push_back(words);
    if (options_.on_note) options_.on_note(words);
  };
  RunResult run;
  std::string error;
  bool machine = false;
  try {
    const Scenario scenario = simulated_scenario(comm_, case_);
    simulated_ice_ = scenario.ice;
    ice_ = simulated_ice_json(comm_, case_, scenario);
    run = simulate(comm_, scaled(hull_.mesh, 1.0 / case_.lambda), scenario, run_options);
  } catch (const std::exception& e) {
    error = *e.what() ? e.what() : "an exception without a message";
    machine = dynamic_cast<const RuntimeError*>(&e) != nullptr;
  }
  if (!comm_.any(!error.empty())) return run;
  std::string message = comm_.broadcast(error);
  if (message.empty()) message = "the simulation failed on another rank than the first";
  if (comm_.any(machine)) throw RuntimeError(message);
  end(EvaluationStatus::failed, message);
  return run;
}

void DesignRun::take(const RunResult& run) {
  if (run.status == RunStatus::ok) {
    e_.result["metrics"] = metrics_json(run, case_.lambda);
    e_.result["metrics"]["resolution_bias"] = resolution_bias_json(case_);
    e_.result["process"] = process_json(run.process);
  }
  const double stress = simulated_ice_.tensile_strength, crushing = simulated_ice_.crushing_pressure;
  e_.result["simulation"] = {{"dt_s", run.dt},
                             {"dt_limit_s", run.dt_limit},
                             {"steps", run.steps},
                             {"ended", ended_json(run)},
                             {"nx", run.nx},
                             {"ny", run.ny},
                             {"nz", run.nz},
                             {"directed_bonds", run.directed_bonds},
                             {"ns_per_bond", run.ns_per_bond},
                             {"linear_share", run.linear_share},
                             {"wall_s", run.wall_seconds},
                             {"output_s", run.output_seconds},
                             {"elastic_modulus_Pa", simulated_ice_.E},
                             {"critical_stretch", stress ? Json(nullptr) : Json(run.s0)},
                             {"tensile_strength_Pa", stress ? Json(stress) : Json(nullptr)},
                             {"crushing_pressure_Pa", crushing ? Json(crushing) : Json(nullptr)},
                             {"load", case_.water.buoyancy_and_gravity ? "whole" : "breaking"},
                             {"ice", ice_},
                             {"lambda", case_.lambda}};
  e_.result["profile"] = profile_json(run);
  Json pictures = Json::array();
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    pictures.push_back({{"file", run.pictures[i]}, {"advance_m", run.picture_advance.at(i)}});
  }
  e_.result["files"]["pictures"] = pictures;
}

// It ran to the end: it is ok where what it was run for is a number.
void DesignRun::judge() {
  const Json& result = e_.result;
  if (asks_for(design_.document, "peridynamics") &&
      !result.at("metrics").at("full_scale").at("mean_load_N").is_number()) {
    return end(EvaluationStatus::failed, "the simulation ended with a mean load that is not a finite number");
  }
  if (!asks_for(design_.document, "peridynamics")) {
    if (asks_for(design_.document, "cycle")) {
      const std::string reason = result.at("cycle").at("reason").get<std::string>();
      if (!reason.empty()) return end(EvaluationStatus::failed, reason);
    } else if (!result.at("lindqvist").at("valid").get<bool>()) {
      return end(EvaluationStatus::failed, result.at("lindqvist").at("reason").get<std::string>());
    }
  }
  e_.status = EvaluationStatus::ok;
}

void DesignRun::describe() {
  e_.result["design"] = design_.name;
  e_.result["status"] = to_string(e_.status);
  e_.result["reason"] = e_.reason;
  e_.result["parameters"] = parameters_json(design_.parameters);
  e_.result["provenance"] = {{"version", program_version()},
                             {"host", host_name()},
                             {"date_utc", utc_now()},
                             {"ranks", comm_.size()},
                             {"wall_s", e_.wall_seconds}};
  if (!notes_.empty()) e_.result["notes"] = notes_;
  for (const char* part : {"hull", "lindqvist", "cycle", "metrics", "process", "simulation", "profile"}) {
    if (!e_.result.contains(part)) e_.result[part] = nullptr;
  }
}

}  // namespace

double usual_checkpoint_interval() {
  const char* given = std::getenv("ICEBOW_CHECKPOINT_SECONDS");
  if (!given) return 300.0;
  char* end = nullptr;
  const double seconds = std::strtod(given, &end);
  if (end == given || *end != '\0' || !(seconds >= 0.0 && seconds <= 1e9))
    throw InputError("ICEBOW_CHECKPOINT_SECONDS=" + shortened(given, 40) +
                     " in the environment: must be a number, allowed 0 to 1e9 s; 0 = only when interrupted");
  return seconds;
}

void remove_checkpoint_in(const std::string& design_directory) {
  remove_checkpoint((std::filesystem::path(design_directory) / checkpoint_name).string());
}

Evaluation evaluate(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  Evaluation e = DesignRun(comm, design, options).run();
  return evaluation_from_json(
      Json::parse(comm.broadcast(json_text(to_json(e)))));  // files, times: as the root has them
}

}  // namespace icebow
