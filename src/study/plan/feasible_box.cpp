#include "study/plan/feasible_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "study/plan/design_space.h"
#include "study/spec/case_hull.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

constexpr int samples = 400, most_rounds = 4;
constexpr double peeled = 0.05;  // of the points, at a time

struct Point {
  std::vector<double> x;
  bool feasible;
  double held;  // what keeps the displacement, in the file's unit
};

Point tried_at(const StudySpec& spec, std::vector<double> x, const std::string& held) {
  const Design design = design_at(spec, "", x).design;
  const auto value = design.parameters.find(held);
  const bool feasible = design.given && check_feasibility(*design.given).feasible;
  return {std::move(x), feasible, value == design.parameters.end() ? 0.0 : value->second};
}

std::vector<Point> tried(const StudySpec& spec, const std::vector<Variable>& box, std::uint64_t seed) {
  std::vector<Point> points;
  std::mt19937_64 random(seed);
  for (int n = 0; n < samples; ++n) {
    std::vector<double> x;
    for (const Variable& v : box)  // 53 bits of the generator, the same on every machine
      x.push_back(rounded(v.lower + static_cast<double>(random() >> 11) * 0x1p-53 * (v.upper - v.lower)));
    points.push_back(tried_at(spec, std::move(x), held_pointer(spec.document)));
  }
  return points;
}

int infeasible(const std::vector<Point>& points) {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [](const Point& p) { return !p.feasible; }));
}

struct Cut {
  std::size_t variable = 0;
  bool upper = false;
  double at = 0.0, worth = -1.0;
};

// Leaves out a share of the points at one end of one variable: most infeasible ones for feasible ones.
Cut best_cut(const std::vector<Point>& points, std::size_t variables) {
  Cut best;
  const std::size_t n =
      std::max<std::size_t>(1, static_cast<std::size_t>(peeled * static_cast<double>(points.size())));
  for (std::size_t v = 0; v < variables; ++v) {
    std::vector<Point> sorted = points;
    std::sort(sorted.begin(), sorted.end(), [v](const Point& a, const Point& b) { return a.x[v] < b.x[v]; });
    for (const bool upper : {false, true}) {
      int bad = 0;
      for (std::size_t k = 0; k < n; ++k) bad += sorted[upper ? sorted.size() - 1 - k : k].feasible ? 0 : 1;
      const double worth = static_cast<double>(bad) / static_cast<double>(n);
      const std::size_t edge = upper ? sorted.size() - 1 - n : n;
      if (worth > best.worth) best = {v, upper, sorted[edge].x[v], worth};
    }
  }
  return best;
}

// Draws the box in until no infeasible point is left in it; false where hardly any point would be.
bool draw_in(std::vector<Variable>& box, std::vector<Point> points) {
  while (infeasible(points) > 0) {
    if (points.size() < 12) return false;
    const Cut cut = best_cut(points, box.size());
    (cut.upper ? box[cut.variable].upper : box[cut.variable].lower) = cut.at;
    points.erase(std::remove_if(points.begin(), points.end(),
                                [&](const Point& p) {
                                  return cut.upper ? p.x[cut.variable] > cut.at : p.x[cut.variable] < cut.at;
                                }),
                 points.end());
  }
  return true;
}

}  // namespace

FeasibleBox feasible_box(const StudySpec& spec) {
  FeasibleBox result;
  const std::vector<Variable>& variables = spec.method.variables;
  const bool ranges =
      std::all_of(variables.begin(), variables.end(), [](const Variable& v) { return v.upper > v.lower; });
  if (variables.empty() || !ranges || spec.baseline.own.given()) return result;
  std::vector<Variable> box = variables;
  std::vector<Point> points = tried(spec, box, 1);
  result.tried = samples;
  result.feasible = samples - infeasible(points);
  result.held = held_pointer(spec.document);
  result.held_lower = std::numeric_limits<double>::infinity(), result.held_upper = -result.held_lower;
  for (const Point& p : points)
    if (p.feasible)
      result.held_lower = std::min(result.held_lower, p.held),
      result.held_upper = std::max(result.held_upper, p.held);
  for (int round = 0; round < most_rounds && infeasible(points) > 0; ++round) {
    if (!draw_in(box, points)) return result;
    points = tried(spec, box, static_cast<std::uint64_t>(round) + 2);
  }
  if (infeasible(points) > 0) return result;
  result.variables = box;
  result.tried_inside = samples;
  return result;
}

}  // namespace icebow
