// Searching a box for the front between two values, by searches for one of them: the method of bounds
// (epsilon-constraint; Haimes, Lasdon and Wismer 1971). Knows nothing of ships.
#pragma once

#include "study/plan/optimiser.h"

namespace icebow {

// The first search looks for the smallest problem.value, the second one for the smallest `second`; further
// ones, at least one and at most six, for the smallest problem.value where `second` is below bounds spread
// evenly between the two. Each starts at the best point that is known to keep its bound and has an even share
// of the points that are left. `second` is asked after problem.value at the same point; smaller is better,
// NaN where there is none.
//
// `best` and `value` are those of the first search; `evaluations` counts all.
OptimiserResult search_front(const OptimiserProblem& problem,
                             const std::function<double(const std::vector<double>&)>& second,
                             const OptimiserOptions& options);

}  // namespace icebow
