#include "study/evaluate/evaluate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "base/collective.h"
#include "base/errors.h"
#include "base/json_fields.h"
#include "base/printable.h"
#include "formula/lindqvist.h"
#include "geometry/mesh_slice.h"
#include "hullgen/drawing/lines_plan.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/mesh/mesh_io.h"
#include "solver/run/checkpoint.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/history_csv.h"
#include "study/evaluate/patch_tests.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/program_evaluator.h"
#include "study/evaluate/provenance.h"
#include "study/evaluate/resolution_bias.h"
#include "study/evaluate/result_json.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/evaluate/voyage_picture.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

// One design on its way to its result.
struct Work {
  const Communicator& comm;
  const Design& design;
  const EvaluateOptions& options;
  Json result;  // so far
  Hull hull;
  std::vector<std::string> notes;  // what a reader of the result should know

  const Case* condition = nullptr;  // the scenario under way; none: the design's own
  bool draws = true;                // of several scenarios, the first has its files
  int conditions_over = 0;          // scenarios before it

  const Case& given() const { return condition ? *condition : *design.given; }
  bool writes() const { return !options.directory.empty() && draws; }
  std::string path(const std::string& file) const {
    return (std::filesystem::path(options.directory) / file).string();
  }
};

// How a step ends: `ok` goes on to the next, anything else leaves the rest out.
struct Ending {
  EvaluationStatus status = EvaluationStatus::ok;
  std::string reason;
};

Ending failed(const std::string& reason) {
  return {EvaluationStatus::failed, reason};
}

Ending read(Work& work) {
  const Design& design = work.design;
  if (!design.given && design.mistake.empty())
    throw std::logic_error("a design that read_design() has not read");
  const std::string mistake = first_trouble(work.comm, design.mistake);
  return mistake.empty() ? Ending{} : failed(mistake);
}

void write_hull(Work& work) {
  write_mesh(work.path("hull.obj"), work.hull.mesh);
  write_text_file(work.path("lines.svg"), lines_plan_svg(work.hull, work.given().bow, work.design.name));
  work.result["files"]["hull"] = "hull.obj";
  work.result["files"]["lines_plan"] = "lines.svg";
}

// The formula takes angles and dimensions: the margins judge a bow without its mesh. A hull of the user's own
// has no margins; only its deformed mesh says whether it folds.
Hull unmeshed(const Case& c) {
  if (c.own.given()) return make_hull(c);
  Hull hull;
  hull.requested = c.bow.angles;
  hull.feasibility = check_feasibility(c);
  hull.reason = hull.feasibility.reason;
  hull.status = hull.feasibility.feasible ? HullStatus::ok : HullStatus::infeasible;
  const double none = std::numeric_limits<double>::quiet_NaN();
  hull.measured = {none, none, none, none};
  hull.waterline_at_quarter_beam = std::atan(std::tan(c.bow.angles.flare) * std::tan(c.bow.angles.buttock));
  hull.flare_at_stem = std::atan(std::tan(c.bow.angles.waterline) / std::tan(c.bow.angles.stem));
  return hull;
}

// At the design draught; null where the water does not cut the mesh.
Json afloat_json(const Case& c, const QuadMesh& mesh) {
  try {
    return hydrostatics_json(hydrostatics(mesh, {0.0, -c.bow.L / 2.0, 0.0}, c.water.rho));
  } catch (const InputError&) {
    return nullptr;
  }
}

Ending measure_hull(Work& work) {
  const Case& c = work.given();
  const bool meshed = !work.design.asked.formula_alone();
  work.hull = meshed ? make_hull(c) : unmeshed(c);
  work.result["ship"] = {{"L_m", c.bow.L}, {"B_m", c.bow.B}, {"T_m", c.bow.T}};
  work.result["hull"] = hull_json(work.hull);
  if (c.own.given()) work.result["hull"]["imported"] = imported_json(c.own);
  if (work.hull.status != HullStatus::ok) return {EvaluationStatus::infeasible, work.hull.reason};
  if (meshed) work.result["hydrostatics"] = afloat_json(c, work.hull.mesh);
  if (meshed && work.writes()) act_on_root(work.comm, [&] { write_hull(work); });
  return {};
}

Ending apply_formula(Work& work) {
  if (!work.design.asked.lindqvist) return {};
  const LindqvistInputs inputs = lindqvist_inputs(work.given());
  work.result["lindqvist"] = lindqvist_json(lindqvist(inputs), inputs);
  return {};
}

void write_history(Work& work, const History& history) {
  write_text_file(work.path("history.csv"), history_csv(history));
  work.result["files"]["history"] = "history.csv";
}

void draw_voyage(Work& work, const CycleOutcome& outcome) {
  const auto lines = slice(work.hull.mesh, 2, 0.0);
  const auto longest = std::max_element(
      lines.begin(), lines.end(), [](const Polyline& a, const Polyline& b) { return a.size() < b.size(); });
  const double shown = 5.0 * work.given().bow.B;
  write_text_file(
      work.path("voyage.svg"),
      voyage_svg(outcome.first_voyage, longest == lines.end() ? Polyline() : *longest,
                 outcome.submersion + outcome.water, shown, work.design.name + ": breaking cycle"));
  work.result["files"]["voyage"] = "voyage.svg";
}

// Where nothing finer is asked for, its record stands where a simulation's would.
Ending run_voyages(Work& work) {
  if (!work.design.asked.cycle) return {};
  cycle::BreakingRule rule;
  try {
    rule = cycle_rule(work.comm, work.given());
  } catch (const InputError& error) {
    return failed(error.what());
  }
  const CycleOutcome outcome = run_cycle(work.given(), work.hull.mesh, rule);
  work.result["cycle"] = cycle_json(outcome, work.given(), rule);
  if (!outcome.reason.empty()) return {};
  const Json metrics = cycle_metrics_json(outcome), process = process_json(outcome.run.process);
  work.result["cycle"]["metrics"] = metrics;
  work.result["cycle"]["process"] = process;
  const bool finest = !work.design.asked.peridynamics;
  if (!finest)
    work.result["cycle"]["same_way"] =
        same_way_json(run_same_way(work.given(), work.hull.mesh, rule, outcome.submersion + outcome.water));
  if (finest) {
    work.result["metrics"] = metrics, work.result["process"] = process;
    for (const char* part : {"cracks", "floes"}) work.result["cycle"]["process"][part].erase("list");
  }
  if (!work.writes()) return {};
  act_on_root(work.comm, [&] {
    draw_voyage(work, outcome);
    if (finest) write_history(work, outcome.run.history);
  });
  return {};
}

// As the root has run it; every rank gets the same, or throws the same.
Json program_on_root(Work& work, const ProgramEvaluator& program) {
  Json told = Json::object();
  if (work.comm.is_root()) {
    try {
      const ProgramOutcome o = run_program(program, program_input(work.given(), work.design.name),
                                           work.options.directory, work.options.stop);
      told = {{"output", o.output},
              {"reason", o.reason},
              {"infeasible", o.infeasible},
              {"timed_out", o.timed_out},
              {"interrupted", o.interrupted}};
    } catch (const std::exception& error) {
      told["machine"] = error.what();
    }
  }
  told = Json::parse(work.comm.broadcast(json_text(told)));
  if (told.contains("machine"))
    throw RuntimeError("the evaluator \"" + program.name + "\": " + told.at("machine").get<std::string>());
  return told;
}

Ending run_programs(Work& work) {
  for (const ProgramEvaluator& program : work.design.asked.programs) {
    const Json told = program_on_root(work, program);
    if (told.at("interrupted").get<bool>()) return {EvaluationStatus::running, "interrupted"};
    const std::string reason = told.at("reason").get<std::string>();
    if (told.at("infeasible").get<bool>())
      return {EvaluationStatus::infeasible, program.name + ": " + reason};
    if (told.at("timed_out").get<bool>())
      work.result["failure"] = {
          {"cause", "time limit"}, {"program", program.name}, {"time_limit_s", program.time_limit}};
    if (!reason.empty()) return failed("the evaluator \"" + program.name + "\" " + reason);
    work.result["programs"][program.name] = told.at("output");
  }
  return {};
}

Ending run_formulas(Work& work) {
  for (const auto step : {apply_formula, run_programs, run_voyages}) {
    const Ending ending = step(work);
    if (ending.status != EvaluationStatus::ok) return ending;
  }
  return {};
}

// A hull and voyages take a while.
Ending look_for_stop(Work& work) {
  const bool stop = work.comm.is_root() && work.options.stop && work.options.stop();
  return work.comm.any(stop) ? Ending{EvaluationStatus::running, "interrupted"} : Ending{};
}

// Of several scenarios as if they were one voyage.
std::function<void(const Progress&)> progress_of(const Work& work) {
  const auto scenarios = static_cast<std::int64_t>(work.design.given->scenarios.size());
  if (!work.options.on_progress || scenarios < 2) return work.options.on_progress;
  return [&tell = work.options.on_progress, scenarios, over = work.conditions_over](Progress p) {
    p.step += over * p.steps, p.steps *= scenarios;
    tell(p);
  };
}

RunOptions run_options(Work& work) {
  const Case& c = work.given();
  RunOptions options;
  if (work.draws) {
    options.directory = work.options.directory;
    options.snapshots = c.snapshots;
    options.pictures = c.pictures;
  }
  options.name = work.design.name;
  options.lambda = c.lambda;
  options.snapshot_format = c.snapshot_format;
  options.seed = c.seed;
  options.on_progress = progress_of(work);
  options.stop = work.options.stop;
  options.checkpoint_now = work.options.checkpoint_now;
  if (!work.options.directory.empty()) options.checkpoint_file = work.path(checkpoint_name);
  options.keep_checkpoint = true;
  options.to_be_sailed_on = work.options.keep_checkpoint && work.design.sail_to > 0.0;
  options.checkpoint_every_s = work.options.checkpoint_every_s;
  options.resume = work.options.resume;
  options.on_resume = work.options.on_resume;
  options.on_note = [&work](const std::string& words) {
    work.notes.push_back(words);
    if (work.options.on_note) work.options.on_note(words);
  };
  return options;
}

struct Simulated {
  RunResult run;
  IceMaterial ice;     // model scale
  Json described;      // the ice, by simulated_ice_json()
  std::string reason;  // why there is no run; empty where there is one
};

// A scenario that cannot be run is the design's fault, and so is one too large for the memory; a full disk is
// not.
Simulated simulated(Work& work) {
  Simulated done;
  std::string error;
  bool machine = false;
  try {
    const Scenario scenario = simulated_scenario(work.comm, work.given());
    done.ice = scenario.ice;
    done.described = simulated_ice_json(work.comm, work.given(), scenario);
    done.run =
        simulate(work.comm, scaled(work.hull.mesh, 1.0 / work.given().lambda), scenario, run_options(work));
  } catch (const std::exception& e) {
    error = *e.what() ? e.what() : "an exception without a message";
    machine = dynamic_cast<const RuntimeError*>(&e) != nullptr;
  }
  if (!work.comm.any(!error.empty())) return done;
  done.reason = work.comm.broadcast(error);
  if (done.reason.empty()) done.reason = "the simulation failed on another rank than the first";
  if (work.comm.any(machine)) throw RuntimeError(done.reason);
  return done;
}

Json pictures_json(const RunResult& run) {
  Json pictures = Json::array();
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    pictures.push_back({{"file", run.pictures[i]}, {"advance_m", run.picture_advance.at(i)}});
  }
  return pictures;
}

Ending sail(Work& work) {
  const Simulated done = simulated(work);
  if (!done.reason.empty()) return failed(done.reason);
  const RunResult& run = done.run;
  if (run.status == RunStatus::ok) {
    work.result["metrics"] = metrics_json(run, work.given().lambda);
    work.result["metrics"]["resolution_bias"] = resolution_bias_json(work.given());
    work.result["process"] = process_json(run.process);
  }
  work.result["simulation"] = simulation_json(run, done.ice, work.given().lambda);
  work.result["simulation"]["load"] = work.given().water.buoyancy_and_gravity ? "whole" : "breaking";
  work.result["simulation"]["ice"] = done.described;
  work.result["profile"] = profile_json(run);
  work.result["files"]["pictures"] = pictures_json(run);
  if (run.status == RunStatus::ok && run.pictures.size() > 1)
    work.result["files"]["animation"] = "breaking.png";
  if (work.writes()) act_on_root(work.comm, [&] { write_history(work, run.history); });
  if (run.status == RunStatus::interrupted) return {EvaluationStatus::running, "interrupted"};
  return run.status == RunStatus::failed ? failed(run.reason) : Ending{};
}

// What is at hand from a run before; else null. The same on every rank.
Json kept(Work& work, const std::string& key) {
  if (work.options.directory.empty() || work.options.resume == Resume::never) return nullptr;
  Json found;
  if (work.comm.is_root()) found = kept_scenario(work.options.directory, key);
  return Json::parse(work.comm.broadcast(json_text(found)));
}

// A voyage that is over leaves its result in place of its checkpoint.
void keep(Work& work, const std::string& key) {
  if (work.options.directory.empty()) return;
  act_on_root(work.comm, [&] {
    keep_scenario(work.options.directory, key, work.result);
    remove_checkpoint(work.path(checkpoint_name));
  });
}

Ending run_scenario(Work& work) {
  Ending ending = run_formulas(work);
  if (ending.status != EvaluationStatus::ok) return ending;
  if (work.design.asked.peridynamics) return sail(work);
  const std::string no_voyage = text_at(work.result, result_key::cycle_reason);
  return no_voyage.empty() ? Ending{} : failed(no_voyage);
}

// One condition after the other, and their loads as one.
Ending run_scenarios(Work& work) {
  const Case& design = *work.design.given;
  if (design.scenarios.empty()) return run_formulas(work);
  const Json before = work.result;
  std::vector<ScenarioResult> results;
  Ending ending;
  for (const CaseScenario& scenario : design.scenarios) {
    work.condition = scenario.given.get();
    work.draws = results.empty();
    work.conditions_over = static_cast<int>(results.size());
    const std::string key = evaluation_key(*scenario.given, work.design.asked);
    work.result = work.design.asked.peridynamics ? kept(work, key) : Json();
    if (work.result.is_null()) {
      work.result = before;
      ending = look_for_stop(work);
      if (ending.status == EvaluationStatus::ok) ending = run_scenario(work);
      if (ending.status == EvaluationStatus::ok && work.design.asked.peridynamics) keep(work, key);
    }
    if (ending.status != EvaluationStatus::ok) {
      if (ending.status != EvaluationStatus::running) ending.reason = scenario.name + ": " + ending.reason;
      break;
    }
    results.push_back({scenario.name, scenario.weight, work.result});
  }
  work.condition = nullptr, work.draws = true;
  if (ending.status == EvaluationStatus::ok) work.result = combined(results, design.by_worst);
  return ending;
}

// Of a design with scenarios each has been sailed.
Ending run_simulation(Work& work) {
  return work.design.asked.peridynamics && work.design.given->scenarios.empty() ? sail(work) : Ending{};
}

// It ran to the end: it is ok where what it was run for is a number.
Ending judge(Work& work) {
  const Json& result = work.result;
  if (work.design.asked.peridynamics) {
    return std::isfinite(number_at(result, result_key::mean_load))
               ? Ending{}
               : failed("the simulation ended with a mean load that is not a finite number");
  }
  if (work.design.asked.cycle) {
    const std::string reason = text_at(result, result_key::cycle_reason);
    return reason.empty() ? Ending{} : failed(reason);
  }
  if (!work.design.asked.programs.empty()) return {};
  const Json& formula = result.at("lindqvist");
  return formula.at("valid").get<bool>() ? Ending{} : failed(formula.at("reason").get<std::string>());
}

Evaluation concluded(const Work& work, const Ending& ending, double seconds) {
  Evaluation e;
  e.name = work.design.name;
  e.parameters = work.design.parameters;
  if (work.design.given) e.key = evaluation_key(work.given(), work.design.asked);
  e.status = ending.status;
  e.reason = ending.reason;
  e.wall_seconds = seconds;
  e.result = work.result;
  e.result["design"] = e.name;
  e.result["status"] = to_string(e.status);
  e.result["reason"] = e.reason;
  e.result["parameters"] = parameters_json(e.parameters);
  e.result["provenance"] = {{"version", program_version()},
                            {"host", host_name()},
                            {"date_utc", utc_now()},
                            {"ranks", work.comm.size()},
                            {"wall_s", seconds}};
  if (work.design.sail_to > 0.0) e.result["sailed_to_m"] = work.design.sail_to;
  if (!work.notes.empty()) e.result["notes"] = work.notes;
  for (const char* part : {"hull", "lindqvist", "cycle", "metrics", "process", "simulation", "profile"}) {
    if (!e.result.contains(part)) e.result[part] = nullptr;
  }
  if (work.writes() && e.status != EvaluationStatus::running) {
    act_on_root(work.comm, [&] {
      write_text_file(work.path("result.json"), json_text(e.result, 2) + "\n");
      if (!work.options.keep_checkpoint) remove_checkpoint_in(work.options.directory);
    });
  }
  return e;
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
  remove_kept_scenarios(design_directory);
  remove_checkpoint((std::filesystem::path(design_directory) / checkpoint_name).string());
}

Evaluation evaluate(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  const auto begin = Clock::now();
  Work work{comm, design, options, {{"files", Json::object()}}, {}, {}};
  if (work.writes()) act_on_root(comm, [&] { std::filesystem::create_directories(options.directory); });
  Ending ending;
  for (const auto step : {read, measure_hull, run_scenarios, look_for_stop, run_simulation, judge}) {
    ending = step(work);
    if (ending.status != EvaluationStatus::ok) break;
  }
  const Evaluation e = concluded(work, ending, std::chrono::duration<double>(Clock::now() - begin).count());
  return evaluation_from_json(
      Json::parse(comm.broadcast(json_text(to_json(e)))));  // files, times: as the root has them
}

}  // namespace icebow
