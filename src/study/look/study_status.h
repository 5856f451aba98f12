// How far the study of a directory is.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// Keys: "name", "state" ("running", "finished", "interrupted", "killed": the run that wrote last has ended
// without a word), "designs" (planned or proposed so far), "may_follow" (more that an optimiser may propose
// at most), "ok", "infeasible", "failed", "damaged", "running" (names), "rank_by", "best", "value" of the
// best, "started" (UTC), "host", "command", "version"; with two objectives "second" {"by", "best"}, "front"
// and "open" (names: study/plan/pareto.h); over scenarios "over_scenarios" ("mean" or "worst") and of the
// best "scenarios" (list of "name", "weight", "mean_load_N", "mean_load_ci95_N"). Reads the store only, while
// a run writes too. Throws InputError where the directory holds no study.
Json study_status(const std::string& directory);

}  // namespace icebow
