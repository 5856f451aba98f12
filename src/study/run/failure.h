// Failures whose cause lies around a design, not in it. The cause is kept with the result, so the design is
// tried again once the cause has changed.
//
// In a result: "failure": {"cause": "time limit", "time_limit_s": 60}, with "program" where it is that of an
// evaluator, or {"cause": "crash", "version": "0.1"}.
#pragma once

#include <string>

#include "study/evaluate/evaluation.h"
#include "study/spec/study_spec.h"

namespace icebow {

// The reason of a design that ran longer than its study allows, and its cause.
std::string time_limit_reason(double limit_s);
Json time_limit_failure(double limit_s);
// The failure of a process that was lost: another version of the program may not lose it.
Json crash_failure();

// What has changed since `failed` failed, in words, such that the design deserves another attempt; empty
// where it would fail again.
std::string changed_since(const Evaluation& failed, const Execution& now, const Evaluators& asked);

// Whether another attempt goes on from the design's checkpoint.
bool goes_on_later(const Evaluation& failed);

}  // namespace icebow
