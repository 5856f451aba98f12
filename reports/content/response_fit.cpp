#include "reports/content/response_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <string>

#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int points_of_a_curve = 25;
constexpr std::size_t most_parameters = 8;

// A parameter mapped to -1 ... 1.
struct Axis {
  std::string pointer;
  double lower = INFINITY, upper = -INFINITY;
  double middle() const { return 0.5 * (lower + upper); }
  double scaled(double value) const { return (value - middle()) / (0.5 * (upper - lower)); }
};

struct Data {
  std::vector<const RankedDesign*> designs;
  std::vector<Axis> axes;
  Matrix x;  // designs by axes, scaled
  Vector y;
};

Vector terms(const Eigen::RowVectorXd& x, bool quadratic) {
  const Eigen::Index n = x.size();
  Vector row(1 + n * (quadratic ? 2 : 1));
  row(0) = 1.0;
  row.segment(1, n) = x.transpose();
  if (quadratic) row.tail(n) = x.transpose().array().square();
  return row;
}

struct Fit {
  bool quadratic = false, good = false;
  Vector beta;
  Matrix covariance;
  double freedom = 0.0, left_out = INFINITY;

  double at(const Eigen::RowVectorXd& x) const { return terms(x, quadratic).dot(beta); }
  double half_width(const Vector& combination) const {
    const double t = boost::math::quantile(boost::math::students_t(freedom), 0.975);
    return t * std::sqrt(std::max(0.0, combination.dot(covariance * combination)));
  }
};

Fit fitted(const Data& data, bool quadratic) {
  Fit fit;
  fit.quadratic = quadratic;
  const Eigen::Index n = data.y.size(), m = 1 + data.x.cols() * (quadratic ? 2 : 1);
  if (n < m + 3) return fit;
  Matrix a(n, m);
  for (Eigen::Index i = 0; i < n; ++i) a.row(i) = terms(data.x.row(i), quadratic).transpose();
  Eigen::ColPivHouseholderQR<Matrix> qr(a);
  qr.setThreshold(1e-6);  // parameters that move together leave no more than this of each other
  if (qr.rank() < m) return fit;
  fit.beta = qr.solve(data.y);
  const Vector residual = data.y - a * fit.beta;
  fit.freedom = static_cast<double>(n - m);
  const Matrix inverse = (a.transpose() * a).inverse();
  fit.covariance = inverse * residual.squaredNorm() / fit.freedom;
  // Leaving out design i changes its own residual by 1 / (1 - leverage).
  double sum = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double leverage = a.row(i).dot(inverse * a.row(i).transpose());
    sum += std::pow(residual(i) / std::max(1e-9, 1.0 - leverage), 2);
  }
  fit.left_out = std::sqrt(sum / static_cast<double>(n));
  fit.good = true;
  return fit;
}

// `held` follows from the others: it is no axis of its own.
std::vector<Axis> axes_of(const std::vector<const RankedDesign*>& designs, const std::string& held) {
  std::map<std::string, Axis> all;
  std::map<std::string, std::size_t> given;
  for (const RankedDesign* design : designs)
    for (const auto& [pointer, value] : design->evaluation.parameters) {
      if (pointer == held) continue;
      Axis& axis = all[pointer];
      axis.pointer = pointer;
      axis.lower = std::min(axis.lower, value), axis.upper = std::max(axis.upper, value);
      ++given[pointer];
    }
  std::vector<Axis> axes;
  for (const auto& [pointer, axis] : all)
    if (given[pointer] == designs.size() && axis.upper - axis.lower > 1e-9 * std::fabs(axis.upper))
      axes.push_back(axis);
  return axes;
}

Data data_of(const StudyResults& study) {
  Data data;
  for (const RankedDesign& row : study.ranking.rows)
    if (row.rank > 0) data.designs.push_back(&row);
  data.axes = axes_of(data.designs, held_pointer(study.document));
  data.x.resize(static_cast<Eigen::Index>(data.designs.size()), static_cast<Eigen::Index>(data.axes.size()));
  data.y.resize(data.x.rows());
  for (Eigen::Index i = 0; i < data.x.rows(); ++i) {
    const RankedDesign& row = *data.designs[static_cast<std::size_t>(i)];
    data.y(i) = row.value;
    for (Eigen::Index k = 0; k < data.x.cols(); ++k) {
      const Axis& axis = data.axes[static_cast<std::size_t>(k)];
      data.x(i, k) = axis.scaled(row.evaluation.parameters.at(axis.pointer));
    }
  }
  return data;
}

Effect effect_of(const Data& data, const Fit& fit, Eigen::Index k) {
  const Axis& axis = data.axes[static_cast<std::size_t>(k)];
  Effect effect;
  effect.pointer = axis.pointer, effect.lower = axis.lower, effect.upper = axis.upper;
  const auto along = [&](double scaled) {
    Eigen::RowVectorXd x = Eigen::RowVectorXd::Zero(data.x.cols());
    x(k) = scaled;
    return x;
  };
  const Vector ends = terms(along(1.0), fit.quadratic) - terms(along(-1.0), fit.quadratic);
  effect.change = ends.dot(fit.beta);
  effect.ci95 = fit.half_width(ends);
  for (int p = 0; p < points_of_a_curve; ++p) {
    const double scaled = -1.0 + 2.0 * p / (points_of_a_curve - 1);
    effect.at.push_back(axis.middle() + 0.5 * scaled * (axis.upper - axis.lower));
    effect.value.push_back(fit.at(along(scaled)));
    effect.half_width.push_back(fit.half_width(terms(along(scaled), fit.quadratic)));
  }
  for (Eigen::Index i = 0; i < data.y.size(); ++i)
    effect.moved.push_back(data.y(i) - fit.at(data.x.row(i)) + fit.at(along(data.x(i, k))));
  return effect;
}

}  // namespace

ResponseFit fit_response(const StudyResults& study) {
  ResponseFit result;
  const Data data = data_of(study);
  if (data.axes.empty() || data.axes.size() > most_parameters) return result;
  const Fit linear = fitted(data, false), curved = fitted(data, true);
  const Fit& fit = curved.left_out < linear.left_out ? curved : linear;
  if (!fit.good || data.y.size() < 2) return result;
  const double mean = data.y.mean();
  const double spread =
      std::sqrt((data.y.array() - mean).square().sum() / static_cast<double>(data.y.size() - 1));
  if (!(fit.left_out < spread)) return result;
  result.designs = static_cast<int>(data.y.size());
  result.quadratic = fit.quadratic;
  result.left_out_error = fit.left_out / mean, result.spread = spread / mean;
  for (Eigen::Index k = 0; k < data.x.cols(); ++k) result.effects.push_back(effect_of(data, fit, k));
  for (const RankedDesign* design : data.designs) result.names.push_back(design->evaluation.name);
  std::stable_sort(result.effects.begin(), result.effects.end(), [](const Effect& a, const Effect& b) {
    return std::fabs(a.change) > std::fabs(b.change);
  });
  return result;
}

}  // namespace icebow
