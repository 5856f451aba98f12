// Notation: u is a point scaled to the unit cube, x the same point in the problem's units.
#include "study/learn/learning_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <random>

#include "base/sha256.h"
#include "base/text.h"
#include "study/learn/expected_gain.h"
#include "study/learn/first_points.h"
#include "study/learn/gaussian_process.h"
#include "study/plan/optimiser.h"

namespace icebow {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using Point = std::vector<double>;
using Points = std::vector<Point>;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double nothing = -std::numeric_limits<double>::infinity();

constexpr int all_over = 1000;   // candidates of a round that cover the cube
constexpr int around_each = 40;  // and around each of the best points
constexpr int best_points = 3;
constexpr int climbs = 3;            // of the best candidates, by NLopt
constexpr double same_point = 1e-4;  // distance below which two points tell the same
constexpr int quiet_rounds = 2;      // of too small a gain that end the search
constexpr int least_observations = 3;

MatrixXd matrix_of(const Points& points, std::size_t dimension) {
  MatrixXd m(static_cast<Index>(points.size()), static_cast<Index>(dimension));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < dimension; ++k)
      m(static_cast<Index>(i), static_cast<Index>(k)) = points[i][k];
  return m;
}

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

// What the processes know together: of the value, and of each constraint.
struct Model {
  std::optional<GaussianProcess> value;
  std::vector<GaussianProcess> constraints;
  double target = nan_value;  // T; NaN where there is no feasible point
  std::vector<std::vector<double>> parameters() const {
    std::vector<std::vector<double>> all;
    if (value) all.push_back(value->parameters());
    for (const GaussianProcess& constraint : constraints) all.push_back(constraint.parameters());
    return all;
  }
};

class Search {
 public:
  Search(const LearningProblem& problem, const LearningOptions& options)
      : problem_(problem), options_(options), d_(problem.lower.size()) {}
  LearningResult run();

 private:
  Point in_units(const Point& u) const;
  Point in_cube(const Point& x) const;
  bool is_feasible(const Point& u) const;
  double prior_at(const Point& u) const { return problem_.prior ? problem_.prior(in_units(u)) : nan_value; }
  VectorXd priors(const Points& points) const;

  void take_known();
  std::string state() const;
  LearningRound round();
  LearningRound first_round() const;
  void ask(const LearningRound& round);
  bool goes_on(const LearningRound& round);

  Observations observations(const std::function<double(const Answer&)>& value, bool of_value) const;
  Model model() const;
  GaussianProcess fitted(const Observations& o, std::size_t which) const;
  std::vector<Observations> constraint_observations() const;
  double target_of(const GaussianProcess& value) const;
  std::vector<std::size_t> best_first(const GaussianProcess& value) const;

  LearningRound learnt_round() const;
  void believe_where_there_is_no_value(Model& model) const;
  Points candidates(const Model& model) const;
  std::vector<double> gains(const Model& model, const Points& points) const;
  Point most_gain(const Model& model, const Points& candidates, const Points& pending, double& gain) const;
  Point climbed(const Model& model, const Point& from) const;
  bool is_new(const Point& u, const Points& pending) const;
  void conclude();

  const LearningProblem& problem_;
  const LearningOptions& options_;
  std::size_t d_;
  Points points_;
  std::vector<Answer> answers_;
  std::vector<std::vector<double>> parameters_;  // of the last fit
  LearningResult result_;
  int quiet_ = 0;
};

Point Search::in_units(const Point& u) const {
  Point x(d_);
  for (std::size_t k = 0; k < d_; ++k)
    x[k] = std::clamp(problem_.lower[k] + u[k] * (problem_.upper[k] - problem_.lower[k]), problem_.lower[k],
                      problem_.upper[k]);
  return x;
}

Point Search::in_cube(const Point& x) const {
  Point u(d_);
  for (std::size_t k = 0; k < d_; ++k)
    u[k] = std::clamp((x[k] - problem_.lower[k]) / (problem_.upper[k] - problem_.lower[k]), 0.0, 1.0);
  return u;
}

bool Search::is_feasible(const Point& u) const {
  if (!problem_.margins) return true;
  const std::vector<double> margins = problem_.margins(in_units(u));
  return std::all_of(margins.begin(), margins.end(), [](double g) { return g >= 0.0; });
}

VectorXd Search::priors(const Points& points) const {
  std::vector<double> values;
  if (problem_.prior)
    for (const Point& u : points) values.push_back(prior_at(u));
  return vector_of(values);
}

void Search::take_known() {
  for (std::size_t i = 0; i < problem_.known.size(); ++i) {
    points_.push_back(in_cube(problem_.known[i]));
    answers_.push_back(problem_.known_answers[i]);
  }
  result_.known = static_cast<int>(points_.size());
}

// All that the next choice depends on, to the last bit.
std::string Search::state() const {
  std::string words =
      text("1 %llu %d %d", static_cast<unsigned long long>(options_.seed), options_.initial, options_.batch);
  const auto add = [&](double value) { words += text(" %a", value); };
  for (const std::vector<double>* list : {&problem_.lower, &problem_.upper, &problem_.start})
    std::for_each(list->begin(), list->end(), add);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::for_each(points_[i].begin(), points_[i].end(), add);
    const Answer& a = answers_[i];
    add(a.value), add(a.variance);
    words += a.feasible ? " y" : " n";
    words += a.exact ? "e" : "";
    std::for_each(a.reserves.begin(), a.reserves.end(), add);
    if (problem_.prior) add(prior_at(points_[i]));
  }
  return sha256(words);
}

LearningRound Search::first_round() const {
  LearningRound round;
  round.gain = nan_value;
  const int wanted = options_.initial > 0 ? options_.initial : 2 * (static_cast<int>(d_) + 1);
  const int n = std::min(options_.max_evaluations, wanted) - result_.known;
  Points taken = points_;
  if (!problem_.start.empty()) {
    const Point u = in_cube(problem_.start);
    if (is_feasible(u) && is_new(u, {})) round.points.push_back(u), taken.push_back(u);
  }
  const int more = n - static_cast<int>(round.points.size());
  for (Point& u : first_points(static_cast<int>(d_), more, options_.seed, taken,
                               [this](const Point& p) { return is_feasible(p); }))
    round.points.push_back(std::move(u));
  return round;
}

bool Search::is_new(const Point& u, const Points& pending) const {
  const auto apart = [&](const Point& other) { return distance(u, other) > same_point; };
  return std::all_of(points_.begin(), points_.end(), apart) &&
         std::all_of(pending.begin(), pending.end(), apart);
}

// Of the answers that have a finite one.
Observations Search::observations(const std::function<double(const Answer&)>& value, bool of_value) const {
  Points points;
  std::vector<double> values, variances;
  Observations o;
  o.exact = true;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double y = value(answers_[i]);
    if (!std::isfinite(y)) continue;
    points.push_back(points_[i]), values.push_back(y);
    const double variance = answers_[i].variance;
    variances.push_back(of_value && std::isfinite(variance) ? variance : 0.0);
    o.exact = o.exact && answers_[i].exact;
  }
  o.points = matrix_of(points, d_);
  o.values = vector_of(values), o.variances = vector_of(variances);
  if (of_value) o.prior = priors(points);
  return o;
}

// One for each constraint, and one of what is infeasible for no reason that has a number: 1 where it is
// feasible, -1 where it is not.
std::vector<Observations> Search::constraint_observations() const {
  std::vector<Observations> all;
  const std::size_t n = answers_.empty() ? 0 : answers_.front().reserves.size();
  for (std::size_t j = 0; j < n; ++j) {
    Observations o = observations([j](const Answer& a) { return a.reserves.at(j); }, false);
    if (o.count() >= least_observations && o.values.minCoeff() < 0.0) all.push_back(std::move(o));
  }
  const auto label = [](const Answer& a) {
    const bool told = std::any_of(a.reserves.begin(), a.reserves.end(), [](double h) { return h < 0.0; });
    return a.feasible ? 1.0 : told ? nan_value : -1.0;
  };
  Observations o = observations(label, false);
  o.exact = false;  // a step is not smooth
  if (o.count() >= least_observations && o.values.minCoeff() < 0.0) all.push_back(std::move(o));
  return all;
}

GaussianProcess Search::fitted(const Observations& o, std::size_t which) const {
  const std::size_t size = d_ + (o.exact ? 1 : 2);
  if (which < parameters_.size() && parameters_[which].size() == size && points_.size() > 3 * d_)
    return fit_process(o, parameters_[which]);
  return fit_process(o);
}

std::vector<std::size_t> Search::best_first(const GaussianProcess& value) const {
  const Predictions p =
      value.at(matrix_of(points_, d_), value.observations().prior.size() > 0 ? priors(points_) : VectorXd());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (answers_[i].feasible && std::isfinite(answers_[i].value)) order.push_back(i);
  const auto surely = [&](std::size_t i) {
    return p.mean[static_cast<Index>(i)] + p.sd[static_cast<Index>(i)];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return surely(a) < surely(b); });
  return order;
}

double Search::target_of(const GaussianProcess& value) const {
  const std::vector<std::size_t> order = best_first(value);
  if (order.empty()) return nan_value;
  const Points best = {points_[order.front()]};
  return value.at(matrix_of(best, d_), value.observations().prior.size() > 0 ? priors(best) : VectorXd())
      .mean[0];
}

Model Search::model() const {
  Model model;
  const Observations o = observations([](const Answer& a) { return a.value; }, true);
  if (o.count() >= least_observations) model.value = fitted(o, 0);
  if (model.value && !model.value->usable()) model.value.reset();
  std::size_t which = model.value ? 1 : 0;
  for (const Observations& c : constraint_observations()) {
    GaussianProcess constraint = fitted(c, which++);
    if (constraint.usable()) model.constraints.push_back(std::move(constraint));
  }
  if (model.value) model.target = target_of(*model.value);
  return model;
}

// ln of (1) at each point.
std::vector<double> Search::gains(const Model& model, const Points& points) const {
  std::vector<double> gains(points.size(), 0.0);
  const MatrixXd at = matrix_of(points, d_);
  if (std::isfinite(model.target)) {
    const bool with_prior = model.value->observations().prior.size() > 0;
    const Predictions p = model.value->at(at, with_prior ? priors(points) : VectorXd());
    const double noise = model.value->noise_variance();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto k = static_cast<Index>(i);
      gains[i] =
          log_expected_improvement(model.target, p.mean[k], p.sd[k]) + log_worth_of_noisy(p.sd[k], noise);
    }
  }
  for (const GaussianProcess& constraint : model.constraints) {
    const Predictions p = constraint.at(at, VectorXd());
    for (std::size_t i = 0; i < points.size(); ++i)
      gains[i] += log_probability_kept(p.mean[static_cast<Index>(i)], p.sd[static_cast<Index>(i)]);
  }
  return gains;
}

// All over the cube, and around the best points at distances from a thousandth to a fifth.
Points Search::candidates(const Model& model) const {
  Points list = turned_sequence(static_cast<int>(d_), all_over, options_.seed + points_.size());
  if (!model.value) return list;
  std::mt19937_64 random(options_.seed + points_.size());
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const std::vector<std::size_t> order = best_first(*model.value);
  for (std::size_t i = 0; i < std::min<std::size_t>(best_points, order.size()); ++i)
    for (int k = 0; k < around_each; ++k) {
      Point u = points_[order[i]];
      const double reach = std::exp(between(std::log(1e-3), std::log(0.2)));
      for (double& coordinate : u) coordinate = std::clamp(coordinate + reach * between(-1.0, 1.0), 0.0, 1.0);
      list.push_back(std::move(u));
    }
  return list;
}

Point Search::climbed(const Model& model, const Point& from) const {
  OptimiserProblem problem;
  problem.lower.assign(d_, 0.0), problem.upper.assign(d_, 1.0);
  problem.start = from;
  problem.value = [&](const Point& u) { return -std::max(-1e6, gains(model, {u}).front()); };
  if (problem_.margins) problem.margins = [this](const Point& u) { return problem_.margins(in_units(u)); };
  OptimiserOptions options;
  options.algorithm = problem_.margins || d_ < 2 ? "cobyla" : "bobyqa";
  options.max_evaluations = static_cast<int>(20 + 10 * d_);
  options.tolerance = 1e-3;
  const OptimiserResult found = optimise(problem, options);
  return found.best.empty() ? from : found.best;
}

// The point of the largest gain among the candidates and where the best of them lead; empty where there is no
// feasible one that is new.
Point Search::most_gain(const Model& model, const Points& list, const Points& pending, double& gain) const {
  const std::vector<double> of_list = gains(model, list);
  std::vector<std::size_t> order(list.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return of_list[a] > of_list[b]; });
  Points starts;
  for (const std::size_t i : order) {
    const bool apart =
        std::all_of(starts.begin(), starts.end(), [&](const Point& s) { return distance(s, list[i]) > 0.1; });
    if (apart && is_new(list[i], pending) && is_feasible(list[i])) starts.push_back(list[i]);
    if (starts.size() == climbs) break;
  }
  Points ends = starts;
  for (const Point& start : starts) ends.push_back(climbed(model, start));
  const std::vector<double> of_ends = gains(model, ends);
  Point best;
  gain = nothing;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (best.empty() ? !is_new(ends[i], pending)
                     : !(of_ends[i] > gain && is_new(ends[i], pending) && is_feasible(ends[i])))
      continue;
    best = ends[i], gain = of_ends[i];
  }
  return best;
}

// Else the model would expect ever more of a part of the box where nothing has a value.
void Search::believe_where_there_is_no_value(Model& model) const {
  if (!model.value) return;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!std::isfinite(answers_[i].value))
      model.value = model.value->believing(matrix_of({points_[i]}, d_).row(0), prior_at(points_[i]));
}

LearningRound Search::learnt_round() const {
  LearningRound round;
  Model known = model();
  round.parameters = known.parameters();
  believe_where_there_is_no_value(known);
  const int room = options_.max_evaluations - result_.evaluations;
  const Points list = candidates(known);
  for (int k = 0; k < std::min(options_.batch, room); ++k) {
    double gain = nothing;
    const Point u = most_gain(known, list, round.points, gain);
    if (u.empty()) break;
    if (k == 0) round.gain = std::isfinite(known.target) ? std::exp(gain) : nan_value;
    round.points.push_back(u);
    const RowVectorXd row = matrix_of({u}, d_).row(0);
    if (known.value) known.value = known.value->believing(row, prior_at(u));
    for (GaussianProcess& constraint : known.constraints) constraint = constraint.believing(row, nan_value);
  }
  return round;
}

LearningRound Search::round() {
  const std::string now = state();
  if (problem_.remembered)
    if (const auto kept = problem_.remembered(now)) return *kept;
  const bool begins = result_.evaluations == 0;
  LearningRound round = begins ? first_round() : LearningRound();
  if (round.points.empty()) round = learnt_round();
  round.state = now;
  if (problem_.remember) problem_.remember(round);
  return round;
}

void Search::ask(const LearningRound& round) {
  Points wanted;
  for (const Point& u : round.points) {
    if (result_.evaluations == options_.max_evaluations) break;
    ++result_.evaluations;
    points_.push_back(u);
    wanted.push_back(in_units(u));
  }
  const std::vector<Answer> answers = problem_.ask(wanted);
  answers_.insert(answers_.end(), answers.begin(), answers.end());
}

bool Search::goes_on(const LearningRound& round) {
  if (std::isfinite(round.gain)) result_.gain = round.gain;
  if (round.points.empty()) {
    result_.reason = "there is no feasible point left that is not known";
    return false;
  }
  double best = nan_value;
  for (const Answer& a : answers_)
    if (a.feasible && std::isfinite(a.value) && !(a.value >= best)) best = a.value;
  quiet_ = round.gain < options_.least_gain * std::fabs(best) ? quiet_ + 1 : 0;
  if (quiet_ == quiet_rounds) result_.reason = "one more point is expected to gain too little";
  return quiet_ < quiet_rounds;
}

void Search::conclude() {
  const Model known = model();
  result_.left_out_error = result_.noise_sd = result_.prior_factor = nan_value;
  if (!known.value) return;
  const std::vector<std::size_t> order = best_first(*known.value);
  result_.left_out_error = known.value->left_out().rms_error;
  result_.noise_sd = std::sqrt(known.value->noise_variance());
  result_.prior_factor = known.value->prior_factor();
  if (order.empty()) return;
  const Points best = {points_[order.front()]};
  const bool with_prior = known.value->observations().prior.size() > 0;
  const Predictions p = known.value->at(matrix_of(best, d_), with_prior ? priors(best) : VectorXd());
  result_.best = in_units(best.front());
  result_.value = p.mean[0], result_.sd = p.sd[0];
}

LearningResult Search::run() {
  take_known();
  result_.gain = nan_value;
  result_.reason = "the allowed number of evaluations was used";
  while (result_.evaluations < options_.max_evaluations) {
    const bool begins = result_.evaluations == 0;
    const LearningRound next = round();
    if (!goes_on(next)) break;
    ask(next);
    parameters_ = next.parameters;
    if (begins && std::isnan(next.gain)) result_.initial = static_cast<int>(next.points.size());
  }
  conclude();
  return result_;
}

}  // namespace

LearningResult search_by_learning(const LearningProblem& problem, const LearningOptions& options) {
  return Search(problem, options).run();
}

}  // namespace icebow
