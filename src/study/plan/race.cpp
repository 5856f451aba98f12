#include "study/plan/race.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace icebow {
namespace {

constexpr double leg_growth = 0.5;
constexpr double small_share = 0.25;  // of the other's squared error: sailing on would hardly help

std::size_t lowest(const std::vector<MeanEstimate>& loads, const std::vector<bool>& in) {
  std::size_t best = loads.size();
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (in[i] && (best == loads.size() || loads[i].mean < loads[best].mean)) best = i;
  return best;
}

// Of the two of an open pair, those whose error matters.
void mark(const std::vector<MeanEstimate>& loads, std::size_t a, std::size_t b, std::vector<bool>& sail_on) {
  const auto squared = [&](std::size_t i) { return loads[i].standard_error * loads[i].standard_error; };
  if (!(squared(a) < small_share * squared(b))) sail_on[a] = true;
  if (!(squared(b) < small_share * squared(a))) sail_on[b] = true;
}

}  // namespace

MeanEstimate load_in_race(MeanEstimate load, const Drift& drift) {
  if (drift.told()) load.standard_error = std::numeric_limits<double>::infinity();
  return load;
}

RaceStanding standing(const std::vector<MeanEstimate>& loads, const std::vector<bool>& in, int leg,
                      const RaceRule& rule) {
  RaceStanding s;
  s.in = in;
  s.sail_on.assign(loads.size(), false);
  const double pairs = std::max<double>(1.0, static_cast<double>(loads.size()) - 1.0);
  const double level = (1.0 - rule.confidence) / (leg * (leg + 1.0)) / pairs;
  for (std::size_t i = 0; i < loads.size(); ++i)
    for (std::size_t j = 0; j < loads.size() && s.in[i]; ++j)
      if (in[i] && in[j] && j != i && most_difference(loads[i], loads[j], level) < 0.0) s.in[i] = false;
  s.leader = lowest(loads, s.in);
  const double load = loads[s.leader].mean;
  for (std::size_t j = 0; j < loads.size(); ++j) {
    if (!s.in[j] || j == s.leader) continue;
    const double above = std::max(0.0, most_difference(loads[j], loads[s.leader], level)) / load;
    s.most_above_best = std::max(s.most_above_best, above);
    if (above > rule.best_within) mark(loads, s.leader, j, s.sail_on);
  }
  s.decided = s.most_above_best <= rule.best_within;
  return s;
}

double next_leg(double counted_from, double sailed_to) {
  return sailed_to + leg_growth * (sailed_to - counted_from);
}

}  // namespace icebow
