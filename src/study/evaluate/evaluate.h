// One design: make the hull, return `infeasible` if it has a problem, else simulate, return its metrics.
#pragma once

#include <functional>
#include <string>

#include "base/communicator.h"
#include "solver/run/simulation.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/evaluation_key.h"

namespace icebow {

struct EvaluateOptions {
  std::string directory;  // of this design's files; made where missing; empty = no files
  std::function<void(const Progress&)> on_progress;
  std::function<bool()> stop;
  // The simulation's checkpoint in that directory: see RunOptions.
  double checkpoint_every_s = 300.0;
  Resume resume = Resume::if_usable;
  std::function<void(std::int64_t step)> on_resume;
};

constexpr const char* checkpoint_name = "checkpoint.h5";

// Collective; all ranks return the same. Never throws for what a design can do wrong: that is a status. An
// interrupted run returns status `running` and must not be stored as finished; the same call goes on with it.
// Files: result.json, history.csv, lines.svg, hull.obj, ice_*.png, and ice.pvd, hull.pvd where snapshots are
// asked for; checkpoint.h5 until the run has ended.
Evaluation evaluate(const Communicator& comm, const Design& design, const EvaluateOptions& options);

}  // namespace icebow
