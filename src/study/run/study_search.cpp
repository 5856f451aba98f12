#include "study/run/study_search.h"

#include "study/plan/constraints.h"
#include "study/plan/design_space.h"
#include "study/plan/front_search.h"
#include "study/plan/ranking.h"
#include "study/plan/repeats.h"

namespace icebow {

Seen seen_of(const StudySpec& spec, const Evaluation& evaluation) {
  const Evaluation e = without_constraints(evaluation);
  Seen seen;
  seen.value = ranking_value(e, spec.rank_by);
  if (spec.second.given())
    seen.second = (spec.second.largest ? -1.0 : 1.0) * ranking_value(e, spec.second.by);
  seen.limits = constraint_margins(spec.constraints, e.result);
  return seen;
}

Seen mean_of(const std::vector<Seen>& runs) {
  const auto mean = [&](const auto& number) {
    std::vector<double> values;
    for (const Seen& run : runs) values.push_back(number(run));
    return repeated_mean(values, values).mean;
  };
  Seen all;
  all.value = mean([](const Seen& run) { return run.value; });
  all.second = mean([](const Seen& run) { return run.second; });
  for (std::size_t k = 0; k < runs.front().limits.size(); ++k)
    all.limits.push_back(mean([k](const Seen& run) { return run.limits[k]; }));
  return all;
}

OptimiserResult search_study(const StudySpec& spec,
                             const std::function<Seen(const std::vector<double>&)>& seen,
                             const std::function<std::vector<double>(const std::vector<double>&)>& margins) {
  OptimiserProblem problem;
  for (const Variable& variable : spec.method.variables) {
    problem.lower.push_back(variable.lower);
    problem.upper.push_back(variable.upper);
  }
  problem.start = start_point(spec);
  problem.value = [&](const std::vector<double>& x) { return seen(x).value; };
  problem.margins = margins;
  problem.limits = number_of_bounds(spec.constraints);
  problem.limit_margins = [&](const std::vector<double>& x) { return seen(x).limits; };
  const Method& method = spec.method;
  const OptimiserOptions options = {method.algorithm, method.seed, method.max_evaluations, method.tolerance};
  if (!spec.second.given()) return optimise(problem, options);
  return search_front(
      problem, [&](const std::vector<double>& x) { return seen(x).second; }, options);
}

}  // namespace icebow
