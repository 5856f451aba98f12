#include "study/effects/response_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/json_fields.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int points_of_a_curve = 25;
constexpr std::size_t most_parameters = 16;
constexpr double least_explained = 0.5;  // for Sobol' indices

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

Data data_of(const Ranking& ranking, const std::string& held) {
  Data data;
  for (const RankedDesign& row : ranking.rows)
    if (row.rank > 0) data.designs.push_back(&row);
  data.axes = axes_of(data.designs, held);
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

Effect effect_of(const Data& data, const PolynomialFit& fit, Eigen::Index k) {
  const Axis& axis = data.axes[static_cast<std::size_t>(k)];
  Effect effect;
  effect.pointer = axis.pointer, effect.lower = axis.lower, effect.upper = axis.upper;
  const auto along = [&](double scaled) {
    Eigen::RowVectorXd x = Eigen::RowVectorXd::Zero(data.x.cols());
    x(k) = scaled;
    return x;
  };
  const Vector ends = fit.row(along(1.0)) - fit.row(along(-1.0));
  effect.change = ends.dot(fit.beta);
  effect.ci95 = fit.half_width(ends);
  for (int p = 0; p < points_of_a_curve; ++p) {
    const double scaled = -1.0 + 2.0 * p / (points_of_a_curve - 1);
    effect.at.push_back(axis.middle() + 0.5 * scaled * (axis.upper - axis.lower));
    effect.value.push_back(fit.at(along(scaled)));
    effect.half_width.push_back(fit.half_width(fit.row(along(scaled))));
  }
  for (Eigen::Index i = 0; i < data.y.size(); ++i)
    effect.moved.push_back(data.y(i) - fit.at(data.x.row(i)) + fit.at(along(data.x(i, k))));
  return effect;
}

// Root mean square of the values' standard errors.
double noise_of(const Data& data, const std::string& rank_by) {
  double sum = 0.0;
  for (const RankedDesign* design : data.designs)
    sum += std::pow(value_estimate(*design, rank_by).standard_error, 2);
  return std::isfinite(sum) ? std::sqrt(sum / static_cast<double>(data.designs.size())) : NAN;
}

bool varies_by_choice(const Data& data) {
  const auto choices = [](const RankedDesign* design) {
    return part_at(design->evaluation.result, result_key::choices);
  };
  return std::any_of(data.designs.begin(), data.designs.end(), [&](const RankedDesign* design) {
    return choices(design) != choices(data.designs.front());
  });
}

// Why nothing can be fitted to such data; empty: it is worth a try.
std::string fault_of(const Data& data) {
  const std::size_t n = data.designs.size(), axes = data.axes.size();
  const std::string parameters = std::to_string(axes) + (axes == 1 ? " parameter" : " parameters");
  if (varies_by_choice(data))
    return "a choice of words varies, like the family, which is no number: sweep each word by itself";
  if (axes == 0) return "no parameter of the study differs among the ranked designs";
  if (axes > most_parameters)
    return parameters + " differ among the designs; at most " + std::to_string(most_parameters) +
           " are fitted";
  if (n < axes + 4)
    return std::to_string(n) + " ranked designs are too few for " + parameters + ": it takes " +
           std::to_string(axes + 4) + " or more";
  return "";
}

// The kind of terms whose left-out error is smallest; false where none can be fitted.
bool best_fit(const Data& data, PolynomialFit& best) {
  bool found = false;
  for (const FitTerms kind : {FitTerms::linear, FitTerms::squares, FitTerms::products, FitTerms::cubes}) {
    PolynomialFit fit;
    if (!fit_polynomial(data.x, data.y, kind, fit) || (found && !(fit.left_out < best.left_out))) continue;
    best = std::move(fit), found = true;
  }
  return found;
}

void add_effects(ResponseFit& result, const Data& data, const PolynomialFit& fit) {
  const Eigen::Index axes = data.x.cols();
  result.has_sobol = result.explained >= least_explained;
  std::vector<SobolIndices> shares;
  if (result.has_sobol) shares = sobol_indices(fit, axes);
  for (Eigen::Index k = 0; k < axes; ++k) {
    result.effects.push_back(effect_of(data, fit, k));
    if (result.has_sobol) result.effects.back().sobol = shares[static_cast<std::size_t>(k)];
  }
  std::stable_sort(result.effects.begin(), result.effects.end(), [](const Effect& a, const Effect& b) {
    return std::fabs(a.change) > std::fabs(b.change);
  });
}

}  // namespace

std::string terms_in_words(FitTerms terms) {
  switch (terms) {
    case FitTerms::linear:
      return "of first degree";
    case FitTerms::squares:
      return "of second degree without products";
    case FitTerms::products:
      return "of second degree with products of two parameters";
    case FitTerms::cubes:
      return "of third degree with products of two parameters";
  }
  return "";
}

ResponseFit fit_response(const Ranking& ranking, const std::string& held) {
  ResponseFit result;
  const Data data = data_of(ranking, held);
  result.why = fault_of(data);
  if (!result.why.empty()) return result;
  PolynomialFit fit;
  if (!best_fit(data, fit)) {
    result.why = "the parameters do not vary independently of each other";
    return result;
  }
  const double mean = data.y.mean();
  const auto n = static_cast<double>(data.y.size());
  const double spread = std::sqrt((data.y.array() - mean).square().sum() / (n - 1.0));
  result.left_out_error = fit.left_out / mean, result.spread = spread / mean;
  result.noise = noise_of(data, ranking.rank_by) / mean;
  if (!(fit.left_out < spread)) {
    result.why = "no polynomial meets a design that is left out better than the mean does";
    return result;
  }
  result.designs = static_cast<int>(data.y.size()), result.terms = fit.kind;
  result.explained = 1.0 - std::pow(fit.left_out / spread, 2);
  add_effects(result, data, fit);
  for (const RankedDesign* design : data.designs) result.names.push_back(design->evaluation.name);
  return result;
}

}  // namespace icebow
