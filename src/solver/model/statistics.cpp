#include "solver/model/statistics.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace icebow {
namespace {

using Values = std::vector<double>;

constexpr int fewest_for_an_interval = 8;

// Everything is computed on values divided by this, so squares cannot overflow.
double largest_magnitude(const Values& values) {
  double largest = 0.0;
  for (double v : values) {
    assert(std::isfinite(v));
    largest = std::max(largest, std::abs(v));
  }
  return largest;
}

double mean_of(const Values& values) {
  double sum = 0.0;
  for (double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

// Linear interpolation between order statistics (definition 7 of Hyndman and Fan).
double quantile(Values values, double probability) {
  const double place = probability * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(below), values.end());
  const double lower = values[below];
  if (below + 1 == values.size()) return lower;
  const double upper =
      *std::min_element(values.begin() + static_cast<std::ptrdiff_t>(below) + 1, values.end());
  return lower + (place - static_cast<double>(below)) * (upper - lower);
}

// Sum over i of d_i d_{i+lag} / n.
double autocovariance(const Values& deviations, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < deviations.size(); ++i) sum += deviations[i] * deviations[i + lag];
  return sum / static_cast<double>(deviations.size());
}

// tau = 1 + 2 sum of autocorrelations, so that var(mean) = var tau / n, by Geyer's (1992) initial monotone
// sequence: sums of adjacent pairs of autocovariances are positive and decreasing in theory; the estimate is
// cut where they stop being positive and never allowed to rise. The last factor removes the bias of
// subtracting the series' own mean (Wolff 2004, eq. 49). Never below 1: a series that swings is not worth
// more than its number of values.
double autocorrelation_time(const Values& deviations) {
  const double n = static_cast<double>(deviations.size());
  const double variance = autocovariance(deviations, 0);
  double pairs = 0.0, previous = std::numeric_limits<double>::infinity();
  std::size_t lag = 0;
  for (; lag + 1 < deviations.size(); lag += 2) {
    const double pair = autocovariance(deviations, lag) + autocovariance(deviations, lag + 1);
    if (pair <= 0.0) break;
    previous = std::min(previous, pair);
    pairs += previous;
  }
  const double tau = 2.0 * pairs / variance - 1.0;
  const double window = static_cast<double>(lag);
  return std::max(1.0, tau * (1.0 + (2.0 * window + 1.0) / n));
}

double students_t_975(double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975);
}

}  // namespace

double interval_of_repeats(const Values& values) {
  const double n = static_cast<double>(values.size()), mean = mean_of(values);
  if (values.size() < 2) return std::numeric_limits<double>::infinity();
  double square = 0.0;
  for (double v : values) square += (v - mean) * (v - mean);
  return students_t_975(n - 1.0) * std::sqrt(square / (n - 1.0) / n);
}

LoadStatistics series_statistics(const Values& values) {
  LoadStatistics result;
  result.samples = static_cast<int>(values.size());
  result.ci95 = std::numeric_limits<double>::infinity();
  if (values.empty()) return result;

  result.max = *std::max_element(values.begin(), values.end());
  result.q95 = quantile(values, 0.95);
  const double n = static_cast<double>(values.size());
  const double scale = largest_magnitude(values);
  if (*std::min_element(values.begin(), values.end()) == result.max) {  // constant
    result.mean = result.max;
    result.effective_samples = n;
    if (result.samples >= fewest_for_an_interval) result.ci95 = 0.0;
    return result;
  }

  Values deviations = values;
  for (double& d : deviations) d /= scale;
  const double mean = mean_of(deviations);
  for (double& d : deviations) d -= mean;
  const double variance = autocovariance(deviations, 0) * n / (n - 1.0);
  result.mean = mean * scale;
  result.standard_deviation = std::sqrt(variance) * scale;
  if (variance == 0.0) {  // the spread is lost in rounding
    result.effective_samples = n;
    if (result.samples >= fewest_for_an_interval) result.ci95 = 0.0;
    return result;
  }
  result.effective_samples = std::max(1.0, n / autocorrelation_time(deviations));
  if (result.samples < fewest_for_an_interval) return result;
  const double t = students_t_975(std::max(1.0, result.effective_samples - 1.0));
  result.ci95 = t * result.standard_deviation / std::sqrt(result.effective_samples);
  return result;
}

namespace {

// Ranks from 1, equal values sharing the average of theirs.
std::vector<double> average_ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    const double average = 0.5 * static_cast<double>(i + 1 + end);
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = average;
  }
  return ranks;
}

}  // namespace

double spearman_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const std::vector<double> a = average_ranks(x), b = average_ranks(y);
  const double mean = 0.5 * static_cast<double>(a.size() + 1);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace icebow
