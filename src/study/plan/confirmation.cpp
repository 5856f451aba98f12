#include "study/plan/confirmation.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdio>
#include <set>

namespace icebow {
namespace {

constexpr const char* mark = "@solver";  // no name of a study file holds an @
constexpr double normal_975 = 1.96;
constexpr int fewest_for_slope = 5;  // designs
constexpr double worthwhile = 0.8;   // a slope must bring the error of designs left out below this part

struct Point {
  std::map<std::string, double> parameters;
  double log_ratio, variance;  // of its own, from both intervals
};

// What the simulation of a design is compared with.
struct ByCycle {
  double load, ci95;
};

ByCycle beside(const Fidelities& d) {
  return std::isfinite(d.beside) ? ByCycle{d.beside, d.beside_ci95} : ByCycle{d.cycle, d.cycle_ci95};
}

std::vector<Point> points_of(const std::vector<Fidelities>& designs) {
  std::vector<Point> points;
  for (const Fidelities& d : designs) {
    const ByCycle cycle = beside(d);
    if (!(d.solver > 0.0) || !(cycle.load > 0.0)) continue;
    const double a = std::isfinite(d.solver_ci95) ? d.solver_ci95 / d.solver : 1.0,
                 b = cycle.ci95 / cycle.load;
    points.push_back(
        {d.parameters, std::log(d.solver / cycle.load), (a * a + b * b) / (normal_975 * normal_975)});
  }
  return points;
}

double at(const std::map<std::string, double>& parameters, const std::string& variable) {
  const auto found = parameters.find(variable);
  return found == parameters.end() ? 0.0 : found->second;
}

// Equal weights: between designs the ratio differs by more than the intervals say. NaN slope: x does not
// vary.
RatioFit line_through(const std::vector<Point>& points, const std::string& variable) {
  RatioFit fit;
  fit.designs = static_cast<int>(points.size());
  fit.variable = variable;
  const double n = fit.designs;
  for (const Point& p : points) fit.constant += p.log_ratio / n, fit.middle += at(p.parameters, variable) / n;
  double xx = 0.0, xy = 0.0, residual = 0.0, own = 0.0;
  for (const Point& p : points) {
    const double x = at(p.parameters, variable) - fit.middle;
    xx += x * x, xy += x * (p.log_ratio - fit.constant);
  }
  if (!variable.empty()) fit.slope = xx > 0.0 ? xy / xx : std::numeric_limits<double>::quiet_NaN();
  for (const Point& p : points) {
    const double x = variable.empty() ? 0.0 : at(p.parameters, variable) - fit.middle;
    residual += std::pow(p.log_ratio - fit.constant - fit.slope * x, 2);
    own += p.variance / n;
  }
  const double freedom = n - (variable.empty() ? 1.0 : 2.0);
  // One design says nothing of the scatter: its own intervals are all there is.
  const double variance = freedom > 0.0 ? std::max(residual / freedom, own) : own;
  fit.between = std::sqrt(std::max(0.0, variance - own));
  fit.constant_error = std::sqrt(variance / n);
  fit.slope_error = xx > 0.0 ? std::sqrt(variance / xx) : 0.0;
  if (freedom > 0.0) fit.students_t = boost::math::quantile(boost::math::students_t(freedom), 0.975);
  return fit;
}

double error_left_out(const std::vector<Point>& points, const std::string& variable) {
  double square = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::vector<Point> others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const RatioFit fit = line_through(others, variable);
    square += std::pow(points[k].log_ratio - std::log(fit.ratio(points[k].parameters)), 2);
  }
  return std::sqrt(square / static_cast<double>(points.size()));
}

std::set<std::string> variables_of(const std::vector<Point>& points) {
  std::set<std::string> names;
  for (const Point& p : points)
    for (const auto& [name, value] : p.parameters) names.insert(name);
  return names;
}

// Distances are in parts of each variable's range over all designs.
class Spread {
 public:
  explicit Spread(const std::vector<Fidelities>& all) {
    for (const Fidelities& d : all) {
      for (const auto& [name, value] : d.parameters) {
        const auto [range, is_new] = ranges_.try_emplace(name, value, value);
        range->second = {std::min(range->second.first, value), std::max(range->second.second, value)};
      }
    }
  }
  double distance(const Fidelities& a, const Fidelities& b) const {
    double square = 0.0;
    for (const auto& [name, range] : ranges_) {
      const double width = range.second - range.first;
      if (width > 0.0) square += std::pow((at(a.parameters, name) - at(b.parameters, name)) / width, 2);
    }
    return std::sqrt(square);
  }

 private:
  std::map<std::string, std::pair<double, double>> ranges_;
};

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

}  // namespace

std::string confirmation_name(const std::string& design) {
  return design + mark;
}
bool is_confirmation(const std::string& name) {
  return name.find(mark) != std::string::npos;
}
std::string confirmed_design(const std::string& name) {
  return name.substr(0, name.find(mark));
}

std::vector<std::string> designs_to_confirm(const std::vector<Fidelities>& ranked, int best, int spread) {
  std::vector<const Fidelities*> chosen, left;
  for (const Fidelities& d : ranked) (static_cast<int>(chosen.size()) < best ? chosen : left).push_back(&d);
  const Spread space(ranked);
  for (int n = 0; n < spread && !left.empty(); ++n) {
    const auto nearest = [&](const Fidelities* d) {
      if (n == 0 && d->design == "baseline") return std::numeric_limits<double>::infinity();
      double least = std::numeric_limits<double>::max();
      for (const Fidelities* c : chosen) least = std::min(least, space.distance(*c, *d));
      return least;
    };
    const auto next =
        std::max_element(left.begin(), left.end(),
                         [&](const Fidelities* a, const Fidelities* b) { return nearest(a) < nearest(b); });
    chosen.push_back(*next);
    left.erase(next);
  }
  std::vector<std::string> names;
  for (const Fidelities* d : chosen) names.push_back(d->design);
  return names;
}

double RatioFit::ratio(const std::map<std::string, double>& parameters) const {
  return std::exp(constant + (variable.empty() ? 0.0 : slope * (at(parameters, variable) - middle)));
}

double RatioFit::half_width(const std::map<std::string, double>& parameters) const {
  const double along = variable.empty() ? 0.0 : slope_error * (at(parameters, variable) - middle);
  return students_t * std::sqrt(between * between + constant_error * constant_error + along * along);
}

double RatioFit::half_width_of_difference(const std::map<std::string, double>& parameters) const {
  const double along = variable.empty() ? 0.0 : slope_error * (at(parameters, variable) - middle);
  const double apart = std::hypot(between, along);
  return apart > 0.0 ? students_t * apart : 0.0;
}

RatioFit fit_ratio(const std::vector<Fidelities>& designs) {
  const std::vector<Point> points = points_of(designs);
  if (points.empty()) return {};
  RatioFit best = line_through(points, "");
  if (points.size() < 2) return best;
  best.error_of_constant = best.error = error_left_out(points, "");
  if (points.size() < fewest_for_slope) return best;
  for (const std::string& variable : variables_of(points)) {
    const double error = error_left_out(points, variable);
    if (!std::isfinite(error) || error >= worthwhile * best.error_of_constant || error >= best.error)
      continue;
    const double of_constant = best.error_of_constant;
    best = line_through(points, variable);
    best.error_of_constant = of_constant, best.error = error;
  }
  return best;
}

std::vector<std::string> disagreements(const RatioFit& fit, const std::vector<Fidelities>& designs) {
  std::vector<std::string> words;
  if (fit.designs == 0) return words;
  const double half = fit.students_t * fit.constant_error;
  const double ratio = std::exp(fit.constant);
  if (fit.designs > 1 && std::abs(fit.constant) > half)
    words.push_back("simulation and breaking cycle disagree on the level: the simulation has " +
                    decimal(ratio) + " (" + decimal(std::exp(fit.constant - half)) + " to " +
                    decimal(std::exp(fit.constant + half)) + ") of the cycle's load, " +
                    std::to_string(fit.designs) + " designs");
  for (const Fidelities& d : designs) {
    if (!std::isfinite(d.solver) || !std::isfinite(d.solver_ci95)) continue;
    const ByCycle cycle = beside(d);
    const double corrected = cycle.load * fit.ratio(d.parameters), own = cycle.ci95 / cycle.load * corrected;
    if (std::abs(d.solver - corrected) <= std::hypot(d.solver_ci95, own)) continue;
    words.push_back("simulation and breaking cycle disagree on " + d.design + ": " + decimal(d.solver / 1e6) +
                    " \u00b1 " + decimal(d.solver_ci95 / 1e6) + " MN simulated, " + decimal(corrected / 1e6) +
                    " \u00b1 " + decimal(own / 1e6) + " MN by the cycle times the ratio of all");
  }
  return words;
}

}  // namespace icebow
