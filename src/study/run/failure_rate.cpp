#include "study/run/failure_rate.h"

#include "base/text.h"

namespace icebow {
namespace {

constexpr int fewest = 5;  // designs by which a rate is judged

}  // namespace

void FailureRate::count(const Evaluation& evaluation) {
  ++evaluated_;
  if (evaluation.status != EvaluationStatus::failed) return;
  ++failed_;
  last_ = evaluation.name + ": " + evaluation.reason;
}

std::string FailureRate::too_many() const {
  if (limit_ <= 0.0 || evaluated_ < fewest || failed_ <= limit_ * evaluated_) return "";
  return text(
             "%d of %d designs failed, more than the part of %g that execution.stop_at_failure_rate allows; "
             "the last "
             "is ",
             failed_, evaluated_, limit_) +
         last_ + ". The same command goes on; with --retry-failed it evaluates them again";
}

}  // namespace icebow
