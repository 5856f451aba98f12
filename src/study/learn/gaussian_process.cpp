#include "study/learn/gaussian_process.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/plan/optimiser.h"

namespace icebow {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double jitter = 1e-9;                    // over s^2: what keeps K positive definite in rounding
constexpr double shortest = 0.03, longest = 20.0;  // l
constexpr double least_signal = 1e-3, most_signal = 1e3;                        // s^2
constexpr double least_nugget = 1e-8, most_nugget = 1.0, likely_nugget = 1e-3;  // g
constexpr double spread_of_lengths = 1.0, spread_of_variances = 2.0;            // of their logarithms

double matern(double squared) {
  const double r = std::sqrt(5.0 * squared);
  return (1.0 + r + r * r / 3.0) * std::exp(-r);
}

double spread(const VectorXd& values) {
  const double mean = values.mean();
  const double sd = std::sqrt((values.array() - mean).square().mean());
  const double least = 1e-12 * std::max(std::fabs(mean), std::numeric_limits<double>::min());
  return sd > least ? sd : std::max(1.0, std::fabs(mean));
}

double square(double x) {
  return x * x;
}

}  // namespace

GaussianProcess::GaussianProcess(std::shared_ptr<const Observations> observations,
                                 const std::vector<double>& parameters)
    : observations_(std::move(observations)), parameters_(parameters) {
  const Observations& o = *observations_;
  const auto d = static_cast<std::size_t>(o.points.cols());
  centre_ = o.values.mean(), unit_ = spread(o.values);
  if (o.prior.size() > 0) prior_centre_ = o.prior.mean(), prior_unit_ = spread(o.prior);
  lengths_ = VectorXd(o.points.cols());
  for (std::size_t k = 0; k < d; ++k) lengths_[static_cast<Index>(k)] = std::exp(-parameters[k]);
  signal_ = std::exp(parameters[d]);
  nugget_ = o.exact ? 0.0 : std::exp(parameters[d + 1]);
  scaled_ = o.points * lengths_.asDiagonal();
  factorise();
}

MatrixXd GaussianProcess::covariances(const MatrixXd& points) const {
  const MatrixXd at = points * lengths_.asDiagonal();
  MatrixXd c(scaled_.rows(), at.rows());
  for (Index j = 0; j < at.rows(); ++j)
    for (Index i = 0; i < scaled_.rows(); ++i)
      c(i, j) = signal_ * matern((scaled_.row(i) - at.row(j)).squaredNorm());
  return c;
}

MatrixXd GaussianProcess::basis(Index rows, const VectorXd& prior) const {
  MatrixXd b = MatrixXd::Ones(rows, observations_->prior.size() > 0 ? 2 : 1);
  if (b.cols() == 2) b.col(1) = (prior.array() - prior_centre_) / prior_unit_;
  return b;
}

void GaussianProcess::factorise() {
  const Observations& o = *observations_;
  const Index n = o.count();
  MatrixXd k(n, n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = j + 1; i < n; ++i)
      k(i, j) = k(j, i) = signal_ * matern((scaled_.row(i) - scaled_.row(j)).squaredNorm());
    k(j, j) = signal_ * (1.0 + jitter) + o.variances[j] / square(unit_) + nugget_;
  }
  factor_.compute(k);
  if (factor_.info() != Eigen::Success) return;
  basis_ = basis(n, o.prior);
  solved_basis_ = factor_.matrixL().solve(basis_);
  basis_factor_.compute(solved_basis_.transpose() * solved_basis_);
  if (basis_factor_.info() != Eigen::Success) return;
  const VectorXd y = (o.values.array() - centre_) / unit_;
  const VectorXd solved = factor_.matrixL().solve(y);
  beta_ = basis_factor_.solve(solved_basis_.transpose() * solved);
  residual_ = y - basis_ * beta_;
  solved_residual_ = factor_.matrixL().solve(residual_);
  usable_ = beta_.allFinite() && solved_residual_.allFinite();
}

double GaussianProcess::log_likelihood() const {
  if (!usable_) return -std::numeric_limits<double>::infinity();
  const double of_k = 2.0 * factor_.matrixLLT().diagonal().array().log().sum();
  const double of_basis = 2.0 * basis_factor_.matrixLLT().diagonal().array().log().sum();
  return -0.5 * (of_k + of_basis + solved_residual_.squaredNorm());
}

Predictions GaussianProcess::at(const MatrixXd& points, const VectorXd& prior) const {
  const MatrixXd solved = factor_.matrixL().solve(covariances(points));  // L^-1 c
  const MatrixXd b = basis(points.rows(), prior);
  const MatrixXd u = b - solved.transpose() * solved_basis_;
  const MatrixXd lower = basis_factor_.matrixL().solve(u.transpose());
  Predictions p;
  p.mean = centre_ + unit_ * (b * beta_ + solved.transpose() * solved_residual_).array();
  const VectorXd variance = signal_ - solved.colwise().squaredNorm().transpose().array() +
                            lower.colwise().squaredNorm().transpose().array();
  p.sd = unit_ * variance.array().max(0.0).sqrt();
  return p;
}

double GaussianProcess::noise_variance() const {
  std::vector<double> known(observations_->variances.begin(), observations_->variances.end());
  std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2), known.end());
  return known[known.size() / 2] + nugget_ * square(unit_);
}

double GaussianProcess::prior_factor() const {
  return beta_.size() > 1 ? beta_[1] * unit_ / prior_unit_ : std::numeric_limits<double>::quiet_NaN();
}

GaussianProcess::LeftOut GaussianProcess::left_out() const {
  constexpr double log_of_2_pi = 1.8378770664093453;
  const Index n = observations_->count();
  const MatrixXd inverse = factor_.solve(MatrixXd::Identity(n, n));
  const MatrixXd with_basis = inverse * basis_;
  const MatrixXd q = inverse - with_basis * basis_factor_.solve(with_basis.transpose());
  const VectorXd y = (observations_->values.array() - centre_) / unit_;
  const VectorXd error = (q * y).array() / q.diagonal().array();
  LeftOut result;
  for (Index i = 0; i < n; ++i)
    result.log_density +=
        0.5 * (std::log(std::max(q(i, i), 1e-300)) - log_of_2_pi - square(error[i]) * q(i, i));
  result.rms_error = unit_ * std::sqrt(error.squaredNorm() / static_cast<double>(n));
  return result;
}

// Scaled by the values that were observed: the parameters keep what they mean.
GaussianProcess GaussianProcess::believing(const Eigen::RowVectorXd& point, double prior) const {
  auto more = std::make_shared<Observations>(*observations_);
  const Index n = more->count();
  VectorXd there(more->prior.size() > 0 ? 1 : 0);
  if (there.size() > 0) there[0] = prior;
  more->points.conservativeResize(n + 1, Eigen::NoChange);
  more->points.row(n) = point;
  more->values.conservativeResize(n + 1);
  more->values[n] = at(point, there).mean[0];
  more->variances.conservativeResize(n + 1);
  more->variances[n] = noise_variance() - nugget_ * square(unit_);
  if (there.size() > 0) {
    more->prior.conservativeResize(n + 1);
    more->prior[n] = prior;
  }
  GaussianProcess result = *this;
  result.observations_ = std::move(more);
  result.scaled_ = result.observations_->points * lengths_.asDiagonal();
  result.usable_ = false;
  result.factorise();
  return result;
}

namespace {

class Fit {
 public:
  explicit Fit(const Observations& observations)
      : observations_(std::make_shared<const Observations>(observations)),
        d_(static_cast<std::size_t>(observations.points.cols())) {
    const auto bound = [&](double least, double most) {
      problem_.lower.push_back(std::log(least)), problem_.upper.push_back(std::log(most));
    };
    for (std::size_t k = 0; k < d_; ++k) bound(shortest, longest);
    bound(least_signal, most_signal);
    if (!observations.exact) bound(least_nugget, most_nugget);
    problem_.value = [this](const std::vector<double>& parameters) { return -log_posterior(parameters); };
  }

  GaussianProcess best_of(const std::vector<std::vector<double>>& starts) {
    OptimiserOptions options;
    options.algorithm = "bobyqa";
    options.max_evaluations = static_cast<int>(30 + 10 * problem_.lower.size());
    options.tolerance = 1e-3;
    OptimiserResult best;
    for (const std::vector<double>& start : starts) {
      problem_.start = start;
      const OptimiserResult found = optimise(problem_, options);
      if (!found.best.empty() && (best.best.empty() || found.value < best.value)) best = found;
    }
    return GaussianProcess(observations_, best.best.empty() ? starts.front() : best.best);
  }

  std::vector<std::vector<double>> usual_starts() const {
    std::vector<std::vector<double>> starts;
    for (const double length : {0.15, 0.5, 1.5}) {
      std::vector<double> start(d_, std::log(length));
      start.push_back(0.0);
      if (!observations_->exact) start.push_back(std::log(likely_nugget));
      starts.push_back(start);
    }
    return starts;
  }

 private:
  double log_posterior(const std::vector<double>& parameters) const {
    double sum = GaussianProcess(observations_, parameters).log_likelihood();
    const double likely_length = std::log(0.5) + 0.5 * std::log(static_cast<double>(d_));
    for (std::size_t k = 0; k < d_; ++k)
      sum -= 0.5 * square((parameters[k] - likely_length) / spread_of_lengths);
    sum -= 0.5 * square(parameters[d_] / spread_of_variances);
    if (!observations_->exact)
      sum -= 0.5 * square((parameters[d_ + 1] - std::log(likely_nugget)) / spread_of_variances);
    return sum;
  }

  std::shared_ptr<const Observations> observations_;
  std::size_t d_;
  OptimiserProblem problem_;
};

GaussianProcess best_fit(const Observations& observations, const std::vector<double>& earlier) {
  Fit fit(observations);
  std::vector<std::vector<double>> all = fit.usual_starts();
  if (!earlier.empty()) all = {earlier, all[1]};
  return fit.best_of(all);
}

}  // namespace

GaussianProcess fit_process(const Observations& observations, const std::vector<double>& earlier) {
  GaussianProcess fitted = best_fit(observations, earlier);
  if (observations.prior.size() == 0) return fitted;
  Observations plain = observations;
  plain.prior.resize(0);
  GaussianProcess without = best_fit(plain, earlier);
  if (!fitted.usable()) return without;
  return without.usable() && without.left_out().log_density >= fitted.left_out().log_density ? without
                                                                                             : fitted;
}

}  // namespace icebow
