// One design: make the hull, return `infeasible` if it has a problem, else simulate, return its metrics.
#pragma once

#include <string>

#include "base/communicator.h"
#include "study/evaluate/evaluate_options.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/evaluation_key.h"

namespace icebow {

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
