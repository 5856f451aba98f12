#include "reports/content/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/json_fields.h"
#include "reports/content/all_runs.h"
#include "reports/content/load_unit.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double wanted_half_width = 0.2;  // of the mean, for an order that can be read

bool is_simulated(const RankedDesign& row) {
  return part_at(row.evaluation.result, result_key::simulation).is_object();
}

// By which the order is told: what all designs share of the error of a corrected level is not in it.
double order_ci95(const RankedDesign& row, const std::string& by) {
  const double shared = value_ci95(row, by);
  if (!std::isfinite(row.difference_ci95) || !(row.mean_load_ci95 > 0.0)) return shared;
  return shared * row.difference_ci95 / row.mean_load_ci95;
}

double run_up_and_steady(const Json& result, double share) {
  const double from = number_at(result, result_key::steady_from);
  const double to = number_at(result, result_key::steady_to);
  return from + share * (to - from);
}

}  // namespace

double independent_samples(const StudyResults& study, const RankedDesign& row) {
  if (study.ranking.rank_by == "lindqvist_breaking" || !is_simulated(row)) return infinite;
  const double all = over_runs(study, row.evaluation, result_key::effective_samples, OverRuns::sum);
  return std::isfinite(all) ? all : infinite;  // an older result does not say
}

MeanDifference compared_with(const RankedDesign& row, const RankedDesign& other, const std::string& rank_by) {
  return mean_difference(value_estimate(other, rank_by), value_estimate(row, rank_by));
}

TooShort too_short(const StudyResults& study) {
  TooShort result;
  const std::string& by = study.ranking.rank_by;
  const int ranked = study.ranked();
  double longer = 1.0;
  std::string widest, fewest;
  for (int i = 0; i < ranked; ++i) {
    const RankedDesign& row = study.ranking.rows[static_cast<std::size_t>(i)];
    const double half = order_ci95(row, by), samples = independent_samples(study, row);
    if (i < 3 && std::isfinite(half) && half > std::fabs(row.value) && widest.empty())
      widest = row.evaluation.name;
    if (i < 3 && samples < fewest_samples && fewest.empty()) fewest = row.evaluation.name;
    if (samples > 0.0 && std::isfinite(samples)) longer = std::max(longer, fewest_samples / samples);
    if (std::isfinite(half) && row.value > 0.0)
      longer = std::max(longer, std::pow(half / row.value / wanted_half_width, 2));
  }
  if (!widest.empty()) {
    result.reason = "the 95\u00a0% interval of " + widest + " is wider than its mean";
  } else if (!fewest.empty()) {
    const auto row = std::find_if(study.ranking.rows.begin(), study.ranking.rows.end(),
                                  [&](const RankedDesign& r) { return r.evaluation.name == fewest; });
    result.reason = "the record of " + fewest + " is worth " + fixed(independent_samples(study, *row), 0) +
                    " independent samples, and " + fixed(fewest_samples, 0) + " are the least";
  }
  if (result.reason.empty()) return result;
  const Json& first = study.ranking.rows.front().evaluation.result;
  result.advance = run_up_and_steady(first, 1.0);
  result.advance_needed = std::ceil(run_up_and_steady(first, longer) / 5.0) * 5.0;
  result.seconds_needed = study.wall_seconds * result.advance_needed / result.advance;
  return result;
}

std::string p_in_words(double p) {
  if (p < 0.001) return "p < 0.001";
  return "p = " + fixed(p, p < 0.0095 ? 3 : 2);
}

}  // namespace icebow
