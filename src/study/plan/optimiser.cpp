// Notation: u is a point scaled to the unit cube, x the same point in the problem's units, f a value divided
// by the first finite one (so of order one, as are the penalties), g a margin.
#include "study/plan/optimiser.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>

#include "base/errors.h"

namespace icebow {
namespace {

struct Algorithm {
  const char* name;
  nlopt::algorithm id;
  bool takes_constraints;
  unsigned least_variables;
};

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> list = {
      {"sbplx", nlopt::LN_SBPLX, false, 1},     {"neldermead", nlopt::LN_NELDERMEAD, false, 1},
      {"bobyqa", nlopt::LN_BOBYQA, false, 2},   {"cobyla", nlopt::LN_COBYLA, true, 1},
      {"crs2_lm", nlopt::GN_CRS2_LM, false, 1}, {"isres", nlopt::GN_ISRES, true, 1},
      {"esch", nlopt::GN_ESCH, false, 1},       {"direct_l", nlopt::GN_DIRECT_L, false, 1}};
  return list;
}

std::string joined_names() {
  std::string text;
  for (const Algorithm& a : algorithms()) text += (text.empty() ? "" : ", ") + std::string(a.name);
  return text;
}

const Algorithm& find_algorithm(const std::string& name, std::size_t variables) {
  for (const Algorithm& a : algorithms()) {
    if (name != a.name) continue;
    if (variables >= a.least_variables) return a;
    throw InputError("the optimiser " + name + " needs at least " + std::to_string(a.least_variables) +
                     " variables, there is " + std::to_string(variables) + "; take cobyla");
  }
  throw InputError("there is no optimiser \"" + name + "\": allowed are " + joined_names());
}

constexpr int halvings = 24;      // of the way back from an infeasible point: to 1e-7 of it
constexpr double way_back = 0.1;  // slope that leads back, over the range of the variables
constexpr double reserve =
    1e-4;  // limits are aimed at from inside, so that the search does not end just beyond
constexpr double limit_weight = 20.0;  // of what is missing, for algorithms that take no constraints

class Search {
 public:
  Search(const OptimiserProblem& problem, const OptimiserOptions& options)
      : problem_(problem),
        options_(options),
        n_(problem.start.size()),
        algorithm_(find_algorithm(options.algorithm, n_)),
        nlopt_(algorithm_.id, static_cast<unsigned>(n_)) {}

  OptimiserResult run();

 private:
  static double objective(const std::vector<double>& u, std::vector<double>&, void* search) {
    return static_cast<Search*>(search)->f(u);
  }
  static void constraints(unsigned m, double* g, unsigned n, const double* u, double*, void* search) {
    static_cast<Search*>(search)->violations(m, g, std::vector<double>(u, u + n));
  }

  double f(const std::vector<double>& u);
  void violations(unsigned m, double* negated, const std::vector<double>& u);
  double violation(const std::vector<double>& x) const;
  std::vector<double> limits_at(const std::vector<double>& x) const;
  double beyond_limits(const std::vector<double>& x, double kept_by) const;
  double seen(double value, const std::vector<double>& x);
  void set_up();
  std::vector<double> start() const;
  bool is_feasible(const std::vector<double>& u) const;
  std::vector<double> brought_in(const std::vector<double>& u) const;
  std::vector<double> in_units(const std::vector<double>& u) const;
  void end(const std::string& reason);

  const OptimiserProblem& problem_;
  const OptimiserOptions& options_;
  std::size_t n_;
  const Algorithm& algorithm_;
  nlopt::opt nlopt_;
  OptimiserResult result_;
  double unit_ = 0.0;           // size of the first finite value; 0 = none yet
  double worst_ = 10.0;         // largest f so far; before there is any, far above one
  std::vector<double> anchor_;  // the first feasible point that had a value; empty: none yet
  bool ended_ = false;
  std::exception_ptr exception_;
};

std::vector<double> Search::in_units(const std::vector<double>& u) const {
  std::vector<double> x(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const double lower = problem_.lower[i], upper = problem_.upper[i];
    x[i] =
        std::clamp(lower + u[i] * (upper - lower), lower, upper);  // some algorithms step out by a rounding
  }
  return x;
}

std::vector<double> Search::start() const {
  std::vector<double> u(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const double lower = problem_.lower[i], upper = problem_.upper[i];
    u[i] = std::clamp((problem_.start[i] - lower) / (upper - lower), 0.0, 1.0);
  }
  return u;
}

// NLopt may go on asking for a while after it was told to stop.
void Search::end(const std::string& reason) {
  if (!ended_) result_.reason = reason;
  ended_ = true;
  nlopt_.force_stop();
}

// Sum of what is missing to zero; 0 = feasible as far as the margins tell.
double Search::violation(const std::vector<double>& x) const {
  double sum = 0.0;
  if (!problem_.margins) return sum;
  for (const double g : problem_.margins(x)) sum += std::isfinite(g) ? std::max(0.0, -g) : 1.0;
  return sum;
}

std::vector<double> Search::limits_at(const std::vector<double>& x) const {
  std::vector<double> margins = problem_.limits > 0 ? problem_.limit_margins(x) : std::vector<double>();
  margins.resize(static_cast<std::size_t>(problem_.limits), -1.0);
  for (double& margin : margins)
    if (!std::isfinite(margin)) margin = -1.0;
  return margins;
}

// Sum of what the limits lack to being kept by so much.
double Search::beyond_limits(const std::vector<double>& x, double kept_by) const {
  double sum = 0.0;
  for (const double margin : limits_at(x)) sum += std::max(0.0, kept_by - margin);
  return sum;
}

// What NLopt is told of a value: always finite, for a NaN hangs or crashes some of its algorithms.
double Search::seen(double value, const std::vector<double>& x) {
  const double missing = violation(x);
  if (!std::isfinite(value)) return worst_ + 0.1 * std::max(1.0, std::fabs(worst_)) + missing;
  const bool better = result_.best.empty() || value < result_.value;
  if (better && missing == 0.0 && beyond_limits(x, 0.0) == 0.0) result_.best = x, result_.value = value;
  const bool first = unit_ == 0.0;
  if (first) unit_ = std::max(std::fabs(value), std::numeric_limits<double>::min());
  double scaled = std::clamp(value / unit_, -1e100, 1e100);
  if (!algorithm_.takes_constraints) scaled += limit_weight * beyond_limits(x, reserve);
  worst_ = first ? scaled : std::max(worst_, scaled);
  return scaled;
}

bool Search::is_feasible(const std::vector<double>& u) const {
  return violation(in_units(u)) == 0.0;
}

// An infeasible point has no value. It is answered with that of the margin's point on the way to the anchor:
// the best bow often lies there. The same point for the same u, once there is an anchor.
std::vector<double> Search::brought_in(const std::vector<double>& u) const {
  if (anchor_.empty() || is_feasible(u)) return u;
  const auto between = [&](double share) {
    std::vector<double> v(n_);
    for (std::size_t i = 0; i < n_; ++i) v[i] = u[i] + share * (anchor_[i] - u[i]);
    return v;
  };
  double outside = 0.0, inside = 1.0;
  for (int halving = 0; halving < halvings; ++halving) {
    const double middle = 0.5 * (outside + inside);
    (is_feasible(between(middle)) ? inside : outside) = middle;
  }
  return between(inside);
}

double Search::f(const std::vector<double>& u) {
  if (ended_) return worst_;
  if (result_.evaluations >= options_.max_evaluations) {
    end("the allowed number of evaluations was used");
    return worst_;
  }
  try {
    const std::vector<double> v = brought_in(u), x = in_units(v);
    double moved = 0.0;
    for (std::size_t i = 0; i < n_; ++i) moved += (v[i] - u[i]) * (v[i] - u[i]);
    ++result_.evaluations;
    const double value = problem_.value(x);
    if (anchor_.empty() && std::isfinite(value) && is_feasible(v)) anchor_ = v;
    return seen(value, x) + way_back * std::sqrt(moved);
  } catch (...) {  // NLopt would turn it into "nlopt failure"
    exception_ = std::current_exception();
    end("error");
    return worst_;
  }
}

void Search::violations(unsigned m, double* negated, const std::vector<double>& u) {
  std::fill(negated, negated + m, 0.0);
  if (ended_) return;
  try {
    std::vector<double> g = problem_.margins ? problem_.margins(in_units(u)) : std::vector<double>();
    for (const double margin : limits_at(in_units(brought_in(u)))) g.push_back(margin - reserve);
    for (unsigned i = 0; i < m; ++i) negated[i] = i < g.size() && std::isfinite(g[i]) ? -g[i] : 1.0;
  } catch (...) {
    exception_ = std::current_exception();
    end("error");
  }
}

void Search::set_up() {
  nlopt_.set_lower_bounds(0.0);
  nlopt_.set_upper_bounds(1.0);
  nlopt_.set_min_objective(objective, this);
  if (options_.tolerance > 0.0) nlopt_.set_xtol_abs(options_.tolerance);
  if (algorithm_.takes_constraints) {
    const std::size_t m = (problem_.margins ? problem_.margins(in_units(start())).size() : 0) +
                          static_cast<std::size_t>(problem_.limits);
    if (m > 0) nlopt_.add_inequality_mconstraint(constraints, this, std::vector<double>(m, 0.0));
  }
  nlopt::srand(static_cast<unsigned long>(
      options_.seed));  // one generator for all of NLopt: seeded just before the start
}

OptimiserResult Search::run() {
  std::vector<double> u = start();
  set_up();
  std::string reason = "the parameters moved less than the tolerance";
  try {
    double f_best = 0.0;
    nlopt_.optimize(u, f_best);
  } catch (const nlopt::forced_stop&) {
  } catch (const nlopt::roundoff_limited&) {
    reason = "rounding errors stopped the progress";
  } catch (const std::exception& error) {
    reason = std::string("the optimiser gave up: ") + error.what();
  }
  if (exception_) std::rethrow_exception(exception_);
  end(reason);
  return result_;
}

}  // namespace

OptimiserResult optimise(const OptimiserProblem& problem, const OptimiserOptions& options) {
  return Search(problem, options).run();
}

const std::vector<std::string>& optimiser_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Algorithm& a : algorithms()) list.emplace_back(a.name);
    return list;
  }();
  return names;
}

}  // namespace icebow
