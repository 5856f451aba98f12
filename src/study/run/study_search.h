// What an optimiser is told of the designs of a study.
#pragma once

#include "study/evaluate/evaluation.h"
#include "study/plan/optimiser.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Of one evaluation. A design that breaks a constraint on its result has its numbers all the same; what else
// is not ok has NaN.
struct Seen {
  double value = 0.0, second = 0.0;  // smaller is better
  std::vector<double> limits;        // study/plan/constraints.h
};
Seen seen_of(const StudySpec& spec, const Evaluation& evaluation);
// Of the runs of one point, one or more: the means of those that have the number.
Seen mean_of(const std::vector<Seen>& runs);

// The study's variables as a problem; `value`, `limits` and `second` (where the study has two objectives) are
// asked by `seen`, `margins` as OptimiserProblem says.
OptimiserResult search_study(const StudySpec& spec,
                             const std::function<Seen(const std::vector<double>&)>& seen,
                             const std::function<std::vector<double>(const std::vector<double>&)>& margins);

}  // namespace icebow
