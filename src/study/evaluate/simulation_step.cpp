#include "study/evaluate/simulation_step.h"

#include "base/collective.h"
#include "base/error_words.h"
#include "base/errors.h"
#include "geometry/quad_mesh.h"
#include "solver/run/simulation.h"
#include "study/evaluate/calibration.h"
#include "study/evaluate/evaluator_inputs.h"
#include "study/evaluate/process_json.h"
#include "study/evaluate/resolution_bias.h"
#include "study/evaluate/result_json.h"

namespace icebow {
namespace {

// Of several scenarios as if they were one voyage.
std::function<void(const Progress&)> progress_of(const DesignWork& work) {
  const auto scenarios = static_cast<std::int64_t>(work.design.given->scenarios.size());
  if (!work.options.on_progress || scenarios < 2) return work.options.on_progress;
  return [&tell = work.options.on_progress, scenarios, over = work.conditions_over](Progress p) {
    p.step += over * p.steps, p.steps *= scenarios;
    tell(p);
  };
}

RunOptions run_options(DesignWork& work) {
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

// A scenario that cannot be run is the design's fault; a full disk and memory that is short are the
// machine's.
Simulated simulated(DesignWork& work) {
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
    error = *e.what() ? in_words(e) : "an exception without a message";
    machine = is_of_machine(e);
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

}  // namespace

StepEnd sail(DesignWork& work) {
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
  return run.status == RunStatus::failed ? failed(run.reason) : StepEnd{};
}

}  // namespace icebow
