// All designs of a study directory with all their numbers, for other programs.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// A list of {"design", "status", "reason", "rank" (0: not ranked), "parameters", "result"}, in the order of
// the study; with two objectives "front" as well (study/plan/pareto.h; empty: no place). Throws InputError
// where the directory holds no study.
Json study_table(const std::string& directory);

// The same as CSV (RFC 4180): a column for each parameter, by its pointer, and for each number of a result
// that is in no list, by its pointer behind "result:". What a design lacks is empty.
std::string study_csv(const Json& table);

}  // namespace icebow
