#include "study/evaluate/evaluate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "base/collective.h"
#include "base/errors.h"
#include "base/json_fields.h"
#include "formula/lindqvist.h"
#include "geometry/mesh_slice.h"
#include "hullgen/drawing/lines_plan.h"
#include "hullgen/hydro/hydrostatics.h"
#include "hullgen/mesh/mesh_io.h"
#include "solver/run/checkpoint.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/cycle_run.h"
#include "study/evaluate/design_work.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/patch_tests.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/program_evaluator.h"
#include "study/evaluate/provenance.h"
#include "study/evaluate/result_json.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/evaluate/simulation_step.h"
#include "study/evaluate/voyage_picture.h"
#include "study/spec/case_hull.h"

namespace icebow {
namespace {

using Clock = std::chrono::steady_clock;

StepEnd read(DesignWork& work) {
  const Design& design = work.design;
  if (!design.given && design.mistake.empty())
    throw std::logic_error("a design that read_design() has not read");
  const std::string mistake = first_trouble(work.comm, design.mistake);
  return mistake.empty() ? StepEnd{} : failed(mistake);
}

void write_hull(DesignWork& work) {
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

StepEnd measure_hull(DesignWork& work) {
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

StepEnd apply_formula(DesignWork& work) {
  if (!work.design.asked.lindqvist) return {};
  const LindqvistInputs inputs = lindqvist_inputs(work.given());
  work.result["lindqvist"] = lindqvist_json(lindqvist(inputs), inputs);
  return {};
}

void draw_voyage(DesignWork& work, const CycleOutcome& outcome) {
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
StepEnd run_voyages(DesignWork& work) {
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
Json program_on_root(DesignWork& work, const ProgramEvaluator& program) {
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

StepEnd run_programs(DesignWork& work) {
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

StepEnd run_formulas(DesignWork& work) {
  for (const auto step : {apply_formula, run_programs, run_voyages}) {
    const StepEnd ending = step(work);
    if (ending.status != EvaluationStatus::ok) return ending;
  }
  return {};
}

// What is at hand from a run before; else null. The same on every rank.
Json kept(DesignWork& work, const std::string& key) {
  if (work.options.directory.empty() || work.options.resume == Resume::never) return nullptr;
  Json found;
  if (work.comm.is_root()) found = kept_scenario(work.options.directory, key);
  return Json::parse(work.comm.broadcast(json_text(found)));
}

// A voyage that is over leaves its result in place of its checkpoint.
void keep(DesignWork& work, const std::string& key) {
  if (work.options.directory.empty()) return;
  act_on_root(work.comm, [&] {
    keep_scenario(work.options.directory, key, work.result);
    remove_checkpoint(work.path(checkpoint_name));
  });
}

StepEnd run_scenario(DesignWork& work) {
  StepEnd ending = run_formulas(work);
  if (ending.status != EvaluationStatus::ok) return ending;
  if (work.design.asked.peridynamics) return sail(work);
  const std::string no_voyage = text_at(work.result, result_key::cycle_reason);
  return no_voyage.empty() ? StepEnd{} : failed(no_voyage);
}

// One condition after the other, and their loads as one.
StepEnd run_scenarios(DesignWork& work) {
  const Case& design = *work.design.given;
  if (design.scenarios.empty()) return run_formulas(work);
  const Json before = work.result;
  std::vector<ScenarioResult> results;
  StepEnd ending;
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
StepEnd run_simulation(DesignWork& work) {
  return work.design.asked.peridynamics && work.design.given->scenarios.empty() ? sail(work) : StepEnd{};
}

// It ran to the end: it is ok where what it was run for is a number.
StepEnd judge(DesignWork& work) {
  const Json& result = work.result;
  if (work.design.asked.peridynamics) {
    return std::isfinite(number_at(result, result_key::mean_load))
               ? StepEnd{}
               : failed("the simulation ended with a mean load that is not a finite number");
  }
  if (work.design.asked.cycle) {
    const std::string reason = text_at(result, result_key::cycle_reason);
    return reason.empty() ? StepEnd{} : failed(reason);
  }
  if (!work.design.asked.programs.empty()) return {};
  const Json& formula = result.at("lindqvist");
  return formula.at("valid").get<bool>() ? StepEnd{} : failed(formula.at("reason").get<std::string>());
}

Evaluation concluded(const DesignWork& work, const StepEnd& ending, double seconds) {
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

void remove_checkpoint_in(const std::string& design_directory) {
  remove_kept_scenarios(design_directory);
  remove_checkpoint((std::filesystem::path(design_directory) / checkpoint_name).string());
}

Evaluation evaluate(const Communicator& comm, const Design& design, const EvaluateOptions& options) {
  const auto begin = Clock::now();
  DesignWork work{comm, design, options, {{"files", Json::object()}}, {}, {}};
  if (work.writes()) act_on_root(comm, [&] { std::filesystem::create_directories(options.directory); });
  StepEnd ending;
  for (const auto step : {read, measure_hull, run_scenarios, look_for_stop, run_simulation, judge}) {
    ending = step(work);
    if (ending.status != EvaluationStatus::ok) break;
  }
  const Evaluation e = concluded(work, ending, std::chrono::duration<double>(Clock::now() - begin).count());
  return evaluation_from_json(
      Json::parse(comm.broadcast(json_text(to_json(e)))));  // files, times: as the root has them
}

}  // namespace icebow
