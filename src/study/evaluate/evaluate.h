// One design: make the hull, return `infeasible` if it has a problem, else simulate, return its metrics.
#pragma once

#include <functional>
#include <string>

#include "base/communicator.h"
#include "solver/run/simulation.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/evaluation_key.h"

namespace icebow {

// Wall time between two checkpoints [s]: 300, or what ICEBOW_CHECKPOINT_SECONDS of the environment says, as
// jobs that are short or disks that are slow may want it. Throws InputError where that is no number from 0
// on.
double usual_checkpoint_interval();

struct EvaluateOptions {
  std::string directory;  // of this design's files; made where missing; empty = no files
  std::function<void(const Progress&)> on_progress;
  std::function<bool()> stop, checkpoint_now;  // see RunOptions
  // The simulation's checkpoint in that directory: see RunOptions.
  double checkpoint_every_s = usual_checkpoint_interval();
  Resume resume = Resume::if_usable;
  // At the end too: the caller removes it once the result is safe. Of a voyage that may be sailed on it is
  // the state of its end.
  bool keep_checkpoint = false;
  std::function<void(std::int64_t step)> on_resume;
  std::function<void(const std::string& words)> on_note;  // on the root: a checkpoint was set aside ...
};

constexpr const char* checkpoint_name = "checkpoint.h5";

// Collective; all ranks return the same. Never throws for what a design can do wrong: that is a status. An
// interrupted run returns status `running` and must not be stored as finished; the same call goes on with it.
// The formula alone makes no mesh: `hull.measured_deg` and `hull.mesh` are null, but for a hull of the user's
// own. Files: result.json, history.csv, lines.svg, hull.obj, ice_*.png, and ice.pvd, hull.vtp where snapshots
// are asked for; checkpoint.h5 until result.json is written. Throws RuntimeError for what the machine does (a
// full disk): that is never a status.
Evaluation evaluate(const Communicator& comm, const Design& design, const EvaluateOptions& options);

// Where the result is safe elsewhere.
void remove_checkpoint_in(const std::string& design_directory);

}  // namespace icebow
