// result.json's part "process": see docs/study_file.md, "Results".
#pragma once

#include "base/json.h"
#include "solver/model/breaking_process.h"

namespace icebow {

// {"thickness_m", "characteristic_length_m", "cracks", "breaking_length", "detached", "floes", "load_cycle",
// "channel", "energy"} at the simulated scale. Lists of cracks and floes hold the 60 largest; counts are of
// all.
Json process_json(const BreakingProcess& process);

}  // namespace icebow
