// Constraints on results: they judge what was evaluated, so a changed bound costs no evaluation.
#pragma once

#include <string>
#include <vector>

#include "study/evaluate/evaluation.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Makes an evaluation that is ok infeasible where its result breaks a constraint, and failed where it lacks
// the number; the result then has "constraint" (the pointer), by which a later call with other constraints
// finds that it was ok.
void apply_constraints(const std::vector<ResultConstraint>& constraints, Evaluation& evaluation);

// The evaluation as it was without its constraints.
Evaluation without_constraints(Evaluation evaluation);

// A margin for each bound, over the size of the bound: 0 or more where it is kept, NaN where the result lacks
// the number.
std::vector<double> constraint_margins(const std::vector<ResultConstraint>& constraints, const Json& result);
int number_of_bounds(const std::vector<ResultConstraint>& constraints);

// Whether the last call found a number missing.
bool lacks_a_number(const Evaluation& evaluation);

}  // namespace icebow
