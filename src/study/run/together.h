// What the ranks of one job need to evaluate designs together.
#pragma once

#include "base/communicator.h"
#include "base/json.h"
#include "study/run/run_settings.h"

namespace icebow {

// The evaluator, with an exception of any rank turned into one of all ranks: nobody is left waiting. (Inside
// the evaluator that is its own duty.) A crash leaves its mark in the design's directory.
Evaluation evaluate_together(const Communicator& comm, const EvaluateFunction& evaluate, const Design& design,
                             const EvaluateOptions& options);

// Where the driver waits for designs to come in: a design that was stopped by its time limit has failed.
void fail_by_time_limit(Evaluation& evaluation, double limit_s);

// How a study ends, as all ranks are told: {"end": outcome} or {"error": message, "input": bool}.
Json end_order(const StudyOutcome& outcome);
Json error_order(const std::exception& error);
bool is_end(const Json& order);
// The outcome, or the error thrown.
StudyOutcome take_end(const Json& order);

}  // namespace icebow
