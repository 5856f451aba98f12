#include "study/run/together.h"

#include "base/error_words.h"
#include "base/errors.h"
#include "study/run/crash_mark.h"
#include "study/run/failure.h"

namespace icebow {
namespace {

Json outcome_json(const StudyOutcome& o) {
  return {{"ok", o.ok},
          {"infeasible", o.infeasible},
          {"failed", o.failed},
          {"recalled", o.recalled},
          {"interrupted", o.interrupted},
          {"best", o.best},
          {"nothing_feasible", o.nothing_feasible},
          {"notes", o.notes}};
}

StudyOutcome outcome_from(const Json& json) {
  StudyOutcome o;
  o.ok = json.at("ok");
  o.infeasible = json.at("infeasible");
  o.failed = json.at("failed");
  o.recalled = json.at("recalled");
  o.interrupted = json.at("interrupted");
  o.best = json.at("best");
  o.nothing_feasible = json.at("nothing_feasible");
  o.notes = json.at("notes").get<std::vector<std::string>>();
  return o;
}

}  // namespace

Evaluation evaluate_together(const Communicator& comm, const EvaluateFunction& evaluate, const Design& design,
                             const EvaluateOptions& options) {
  Evaluation result;
  std::string error;
  const CrashMark mark(options.directory + "/" + crash_mark_name);
  try {
    result = evaluate(comm, design, options);
  } catch (const std::exception& e) {
    error = std::string("evaluating ") + design.name + ": " + in_words(e);
  }
  if (!comm.any(!error.empty())) return result;
  throw RuntimeError(error.empty() ? "evaluating " + design.name + " failed on another rank" : error);
}

void fail_by_time_limit(Evaluation& e, double limit_s) {
  if (e.status != EvaluationStatus::running) return;
  e.status = EvaluationStatus::failed;
  e.reason = time_limit_reason(limit_s);
  e.result["failure"] = time_limit_failure(limit_s);
}

Json end_order(const StudyOutcome& outcome) {
  return {{"end", outcome_json(outcome)}};
}

Json error_order(const std::exception& error) {
  return {{"error", error.what()}, {"input", dynamic_cast<const InputError*>(&error) != nullptr}};
}

bool is_end(const Json& order) {
  return order.contains("end") || order.contains("error");
}

StudyOutcome take_end(const Json& order) {
  if (order.contains("end")) return outcome_from(order.at("end"));
  const std::string message = order.at("error");
  if (order.at("input").get<bool>()) throw InputError(message);
  throw RuntimeError(message);
}

}  // namespace icebow
