#include "study/effects/elementary.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>

namespace icebow {
namespace {

constexpr std::size_t most_designs = 5000;
constexpr double step = 2.0 / 3.0, rounding = 1e-6;  // over the range; parameters have ten digits

struct Range {
  double lower = INFINITY, upper = -INFINITY;
  double size() const { return upper - lower; }
};

using Ranges = std::map<std::string, Range>;

Ranges ranges_of(const std::vector<const RankedDesign*>& designs) {
  Ranges ranges;
  for (const RankedDesign* design : designs)
    for (const auto& [pointer, value] : design->evaluation.parameters) {
      Range& range = ranges[pointer];
      range.lower = std::min(range.lower, value), range.upper = std::max(range.upper, value);
    }
  return ranges;
}

// The one parameter in which two designs differ, and by which part of its range; empty where there is no
// such.
std::pair<std::string, double> one_difference(const RankedDesign& a, const RankedDesign& b,
                                              const Ranges& ranges) {
  std::pair<std::string, double> found;
  for (const auto& [pointer, value] : a.evaluation.parameters) {
    const auto other = b.evaluation.parameters.find(pointer);
    if (other == b.evaluation.parameters.end()) return {};
    if (other->second == value) continue;
    if (!found.first.empty()) return {};
    found = {pointer, (other->second - value) / ranges.at(pointer).size()};
  }
  return found;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return values.size() > 1 ? std::sqrt(sum / static_cast<double>(values.size() - 1)) : NAN;
}

ElementaryEffects summed_up(const std::string& pointer, const std::vector<double>& changes) {
  std::vector<double> sizes;
  for (const double change : changes) sizes.push_back(std::fabs(change));
  const auto n = static_cast<double>(changes.size());
  ElementaryEffects e{pointer,          static_cast<int>(changes.size()),
                      mean_of(changes), deviation_of(changes),
                      mean_of(sizes),   NAN};
  if (changes.size() > 1)
    e.mean_size_ci95 =
        boost::math::quantile(boost::math::students_t(n - 1.0), 0.975) * deviation_of(sizes) / std::sqrt(n);
  return e;
}

}  // namespace

std::vector<ElementaryEffects> elementary_effects(const Ranking& ranking) {
  std::vector<const RankedDesign*> designs;
  for (const RankedDesign& row : ranking.rows)
    if (row.rank > 0) designs.push_back(&row);
  std::vector<ElementaryEffects> effects;
  if (designs.size() > most_designs) return effects;
  const Ranges ranges = ranges_of(designs);
  std::map<std::string, std::vector<double>> changes;
  for (std::size_t i = 0; i < designs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto [pointer, part] = one_difference(*designs[i], *designs[k], ranges);
      if (pointer.empty() || std::fabs(std::fabs(part) - step) > rounding) continue;
      changes[pointer].push_back((designs[k]->value - designs[i]->value) / part);
    }
  for (const auto& [pointer, list] : changes) effects.push_back(summed_up(pointer, list));
  std::sort(effects.begin(), effects.end(),
            [](const ElementaryEffects& a, const ElementaryEffects& b) { return a.mean_size > b.mean_size; });
  return effects;
}

}  // namespace icebow
