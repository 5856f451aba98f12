// What differs between two study directories: what was asked, and what came of the same designs.
#pragma once

#include <string>

#include "base/json.h"

namespace icebow {

// Keys: "study": list of {"at" (pointer into the study file), "first", "second"}, null where one lacks it;
// "designs": list of {"first" and "second": {"design", "rank", "value"}, "ratio" of the second value to the
// first (null where one is none)}; "only_first", "only_second": names; "rank_by" of both.
//
// A design of both is one of the same name, where the study file names it; of a method's points it is the one
// with the same parameters. Throws InputError where a directory holds no study.
Json study_diff(const std::string& first, const std::string& second);

}  // namespace icebow
