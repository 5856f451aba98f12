#include "study/plan/front_search.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

struct Tried {
  std::vector<double> x;
  double first, second;
};

class FrontSearch {
 public:
  FrontSearch(const OptimiserProblem& problem,
              const std::function<double(const std::vector<double>&)>& second,
              const OptimiserOptions& options)
      : problem_(problem), second_(second), options_(options) {}

  OptimiserResult run();

 private:
  OptimiserProblem recorded();
  OptimiserResult search(const OptimiserProblem& problem, int searches_left);
  void search_between(double from, double to, int searches);
  bool keeps_limits(const std::vector<double>& x) const;

  const OptimiserProblem& problem_;
  const std::function<double(const std::vector<double>&)>& second_;
  const OptimiserOptions& options_;
  std::vector<Tried> tried_;  // that keep the limits
  int used_ = 0;
};

bool FrontSearch::keeps_limits(const std::vector<double>& x) const {
  if (problem_.limits == 0) return true;
  const std::vector<double> margins = problem_.limit_margins(x);
  return std::all_of(margins.begin(), margins.end(), [](double margin) { return margin >= 0.0; });
}

// The problem as it is, each point noted.
OptimiserProblem FrontSearch::recorded() {
  OptimiserProblem problem = problem_;
  problem.value = [this](const std::vector<double>& x) {
    const double first = problem_.value(x), second = second_(x);
    if (std::isfinite(first) && std::isfinite(second) && keeps_limits(x))
      tried_.push_back({x, first, second});
    return first;
  };
  return problem;
}

OptimiserResult FrontSearch::search(const OptimiserProblem& problem, int searches_left) {
  OptimiserOptions options = options_;
  options.max_evaluations = (options_.max_evaluations - used_) / searches_left;
  if (options.max_evaluations < 1) return {};
  OptimiserResult result = optimise(problem, options);
  used_ += result.evaluations;
  return result;
}

// The bounds come one after the other from the end of the first search to that of the second.
void FrontSearch::search_between(double from, double to, int searches) {
  for (int k = 1; k <= searches; ++k) {
    const double bound = from + (to - from) * k / (searches + 1), size = std::fabs(to - from);
    OptimiserProblem problem = recorded();
    problem.limits = problem_.limits + 1;
    problem.limit_margins = [this, bound, size](const std::vector<double>& x) {
      std::vector<double> margins = problem_.limits > 0 ? problem_.limit_margins(x) : std::vector<double>();
      margins.push_back((bound - second_(x)) / size);
      return margins;
    };
    const Tried* start = nullptr;
    for (const Tried& t : tried_)
      if (t.second <= bound && (!start || t.first < start->first)) start = &t;
    if (start) problem.start = start->x;
    search(problem, searches - k + 1);
  }
}

OptimiserResult FrontSearch::run() {
  const int variables = static_cast<int>(problem_.lower.size());
  const int between = std::clamp(options_.max_evaluations / (8 * (variables + 1)) - 2, 1, 6);
  OptimiserResult first = search(recorded(), between + 2);
  first.reason = "the front was searched by " + std::to_string(between + 2) + " searches";
  if (first.best.empty()) {
    first.reason = "no point has both values";
    return first;
  }
  OptimiserProblem other = recorded();
  other.value = [value = other.value, this](const std::vector<double>& x) {
    return std::isfinite(value(x)) ? second_(x) : NAN;
  };
  search(other, between + 1);
  const auto least_first = std::min_element(tried_.begin(), tried_.end(),
                                            [](const Tried& a, const Tried& b) { return a.first < b.first; });
  const auto least_second = std::min_element(
      tried_.begin(), tried_.end(), [](const Tried& a, const Tried& b) { return a.second < b.second; });
  if (tried_.empty() || least_first->second == least_second->second)
    first.reason =
        "the design of the smallest first objective has the best second one too: there is no front";
  else
    search_between(least_first->second, least_second->second, between);
  first.evaluations = used_;
  return first;
}

}  // namespace

OptimiserResult search_front(const OptimiserProblem& problem,
                             const std::function<double(const std::vector<double>&)>& second,
                             const OptimiserOptions& options) {
  return FrontSearch(problem, second, options).run();
}

}  // namespace icebow
