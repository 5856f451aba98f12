#include "study/plan/nearest_feasible.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/dimensions.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/feasibility.h"
#include "study/plan/optimiser.h"

namespace icebow {
namespace {

constexpr double degree_weight = 5.0, length_weight = 0.1;  // changes that count alike [deg], [-]
constexpr double farthest = 30.0;                           //!< [deg]
// Kept from a margin's end, so that rounding to two decimals does not cross it: [m], [-] and [rad].
constexpr double slack_of_lengths = 0.03, slack_of_others = 5e-3, slack_of_ranges = 1e-4;

struct Parameter {
  const char* name;
  double BowParameters::*length;  // null: an angle
  double BowAngles::*angle;
};
constexpr Parameter parameters[] = {
    {"stem angle", nullptr, &BowAngles::stem},       {"waterline angle", nullptr, &BowAngles::waterline},
    {"buttock angle", nullptr, &BowAngles::buttock}, {"flare angle", nullptr, &BowAngles::flare},
    {"bow length Lf", &BowParameters::Lf, nullptr},  {"length L", &BowParameters::L, nullptr}};

// In degrees or metres.
double value_of(const BowParameters& bow, const Parameter& p) {
  return p.length ? bow.*p.length : degrees(bow.angles.*p.angle);
}
void set(BowParameters& bow, const Parameter& p, double value) {
  if (p.length)
    bow.*p.length = value;
  else
    bow.angles.*p.angle = radians(value);
}

using Held = std::optional<HeldDisplacement>;

double& kept_by(BowParameters& bow, HeldBy by) {
  return by == HeldBy::beam ? bow.B : by == HeldBy::draft ? bow.T : bow.L;
}

// NaN for the dimension that keeps the displacement where none does: every margin is then violated.
BowParameters at(const BowParameters& bow, const std::vector<double>& x, const Held& held) {
  BowParameters result = bow;
  for (std::size_t k = 0; k < x.size(); ++k) set(result, parameters[k], x[k]);
  if (!held) return result;
  kept_by(result, held->by) =
      dimension_for_displacement(result, held->volume, held->by, held->lower, held->upper)
          .value_or(std::nan(""));
  return result;
}

double slack_of(const Margin& g) {
  if (g.name == "g6") return slack_of_ranges;
  return g.name == "g3" || g.name == "g4" || g.name == "g7" ? slack_of_others : slack_of_lengths;
}

OptimiserProblem problem_of(const BowParameters& bow, const Held& held) {
  OptimiserProblem problem;
  for (const Parameter& p : parameters) {
    const double value = value_of(bow, p);
    problem.start.push_back(value);
    const bool ship = p.length == &BowParameters::L;
    const double highest = p.angle == &BowAngles::waterline ? 90.0 : 88.99;
    problem.lower.push_back(p.length ? (ship ? value : 0.5 * value)
                                     : std::clamp(value - farthest, 1.01, 80.0));
    problem.upper.push_back(p.length ? 2.0 * value : std::clamp(value + farthest, 10.0, highest));
  }
  problem.value = [bow](const std::vector<double>& x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double was = value_of(bow, parameters[k]);
      sum += std::pow((x[k] - was) / (parameters[k].length ? length_weight * was : degree_weight), 2);
    }
    return sum;
  };
  problem.margins = [bow, held](const std::vector<double>& x) {
    std::vector<double> margins;
    for (const Margin& g : check_feasibility(at(bow, x, held)).margins)
      margins.push_back(g.required ? g.value - slack_of(g) : 1.0);
    return margins;
  };
  return problem;
}

// To the fewest decimals, from two on, with which the bow stays feasible.
std::optional<std::vector<double>> rounded(const BowParameters& bow, const std::vector<double>& best,
                                           const Held& held) {
  for (double unit = 1e-2; unit > 1e-9; unit *= 0.1) {
    std::vector<double> x = best;
    for (std::size_t k = 0; k < x.size(); ++k) {
      // What hardly moved does not move.
      const double was = value_of(bow, parameters[k]);
      x[k] = std::abs(x[k] - was) < 0.5 * unit ? was : unit * std::round(x[k] / unit);
    }
    if (check_feasibility(at(bow, x, held)).feasible) return x;
  }
  return {};
}

}  // namespace

std::optional<NearestBow> nearest_feasible(const BowParameters& bow, const Held& held) {
  if (!dimension_problem(bow).empty() || !std::isfinite(angle_range(bow.angles).margin)) return {};
  OptimiserOptions options;
  options.algorithm = "cobyla";
  // Beam and draught that keep a displacement are found by bisection, at each evaluation.
  options.max_evaluations = held && held->by != HeldBy::length ? 600 : 3000;
  options.tolerance = 1e-5;
  // The search's own best is the start, at no distance: what counts is the best point with its margins kept.
  OptimiserProblem problem = problem_of(bow, held);
  std::vector<double> best;
  double least = 1e300;
  const auto distance = problem.value;
  problem.value = [&](const std::vector<double>& x) {
    const double value = distance(x);
    const std::vector<double> margins = problem.margins(x);
    const bool kept = std::all_of(margins.begin(), margins.end(), [](double g) { return g >= -1e-3; });
    if (kept && value < least) least = value, best = x;
    return value;
  };
  optimise(problem, options);
  if (best.empty()) {  // the way from there is barred: come from the middle of the family
    const BowParameters preset = preset_bow(bow.family);
    BowParameters middle = bow;
    middle.angles = preset.angles;
    middle.Lf = preset.Lf * bow.B / preset.B;
    for (std::size_t k = 0; k < problem.start.size(); ++k) problem.start[k] = value_of(middle, parameters[k]);
    for (std::size_t k = 0; k < problem.start.size(); ++k) {
      problem.lower[k] = std::min(problem.lower[k], problem.start[k]);
      problem.upper[k] = std::max(problem.upper[k], problem.start[k]);
    }
    optimise(problem, options);
  }
  if (best.empty()) return {};
  const auto x = rounded(bow, best, held);
  if (!x) return {};
  NearestBow nearest;
  nearest.bow = at(bow, *x, held);
  for (std::size_t k = 0; k < x->size(); ++k) {
    const double was = value_of(bow, parameters[k]);
    const bool follows = held && held->by == HeldBy::length && parameters[k].length == &BowParameters::L;
    if ((*x)[k] != was && !follows)
      nearest.changes.push_back(
          text("%s %.10g -> %.10g %s", parameters[k].name, was, (*x)[k], parameters[k].length ? "m" : "deg"));
  }
  if (held) {
    BowParameters was = bow;
    const char* name = held->by == HeldBy::beam    ? "beam B"
                       : held->by == HeldBy::draft ? "draught T"
                                                   : "length L";
    nearest.changes.push_back(text("and, to keep %.10g m3, %s %.10g -> %.10g m", held->volume, name,
                                   kept_by(was, held->by), kept_by(nearest.bow, held->by)));
  }
  return nearest;
}

std::string nearest_feasible_words(const BowParameters& bow, const Held& held) {
  const auto nearest = nearest_feasible(bow, held);
  if (!nearest) return "";
  std::string words;
  for (const std::string& change : nearest->changes) words += (words.empty() ? "" : ", ") + change;
  return "the nearest feasible bow as a whole: " + words;
}

}  // namespace icebow
