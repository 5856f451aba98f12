#include "study/run/failure.h"

#include "base/json_fields.h"
#include "base/text.h"
#include "study/evaluate/provenance.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

constexpr const char *time_limit = "time limit", *crash = "crash";

std::string cause_of(const Evaluation& failed) {
  if (failed.status != EvaluationStatus::failed) return "";
  return text_at(failed.result, result_key::failure_cause);
}

}  // namespace

std::string time_limit_reason(double limit_s) {
  return text(
      "longer than the time limit of %g s (execution/time_limit_s); with a higher limit the same command "
      "goes "
      "on with it",
      limit_s);
}

Json time_limit_failure(double limit_s) {
  return {{"cause", time_limit}, {"time_limit_s", limit_s}};
}

Json crash_failure() {
  return {{"cause", crash}, {"version", program_version()}};
}

std::string changed_since(const Evaluation& failed, const Execution& now, const Evaluators& asked) {
  const std::string cause = cause_of(failed), program = text_at(failed.result, result_key::failed_program);
  const double before = number_at(failed.result, result_key::failed_time_limit);
  double limit = now.time_limit_s;
  for (const ProgramEvaluator& one : asked.programs)
    if (one.name == program) limit = one.time_limit;
  if (cause == time_limit && limit == 0.0) return text("the time limit of %g s was taken away", before);
  if (cause == time_limit && limit > before)
    return text("the time limit was raised from %g to %g s", before, limit);
  const std::string version = text_at(failed.result, result_key::failed_version);
  if (cause == crash && version != program_version())
    return "it crashed version " + version + " of the program, this is " + program_version();
  return "";
}

bool goes_on_later(const Evaluation& failed) {
  return cause_of(failed) == time_limit;
}

}  // namespace icebow
