#include "study/plan/constraints.h"

#include <cmath>
#include <utility>

#include "base/json_fields.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr const char* broken = "constraint";

void restore(Evaluation& e) {
  if (!e.result.is_object() || !e.result.contains(broken)) return;
  e.status = EvaluationStatus::ok;
  e.reason.clear();
  e.result.erase(broken);
}

// In words; empty where it is kept.
std::string breach(const ResultConstraint& c, double value) {
  const std::string is = c.at + " is " + brief(value);
  if (value < c.lower) return is + ", less than its constraint of " + brief(c.lower);
  return value > c.upper ? is + ", more than its constraint of " + brief(c.upper) : "";
}

}  // namespace

void apply_constraints(const std::vector<ResultConstraint>& constraints, Evaluation& e) {
  restore(e);
  for (const ResultConstraint& c : constraints) {
    if (e.status != EvaluationStatus::ok) return;
    const double value = number_at(e.result, c.at);
    const bool missing = !std::isfinite(value);
    e.reason = missing ? "its result has no number " + c.at + ", which has a constraint" : breach(c, value);
    if (e.reason.empty()) continue;
    e.status = missing ? EvaluationStatus::failed : EvaluationStatus::infeasible;
    e.result[broken] = c.at;
  }
}

Evaluation without_constraints(Evaluation evaluation) {
  restore(evaluation);
  return evaluation;
}

std::vector<double> constraint_margins(const std::vector<ResultConstraint>& constraints, const Json& result) {
  std::vector<double> margins;
  for (const ResultConstraint& c : constraints) {
    const double value = number_at(result, c.at);
    for (const auto& [bound, direction] : {std::pair(c.lower, 1.0), std::pair(c.upper, -1.0)})
      if (std::isfinite(bound))
        margins.push_back(direction * (value - bound) / (bound != 0.0 ? std::fabs(bound) : 1.0));
  }
  return margins;
}

int number_of_bounds(const std::vector<ResultConstraint>& constraints) {
  int number = 0;
  for (const ResultConstraint& c : constraints) number += std::isfinite(c.lower) + std::isfinite(c.upper);
  return number;
}

bool lacks_a_number(const Evaluation& e) {
  return e.status == EvaluationStatus::failed && e.result.is_object() && e.result.contains(broken);
}

}  // namespace icebow
