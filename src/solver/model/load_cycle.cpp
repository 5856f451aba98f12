#include "solver/model/load_cycle.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>

namespace icebow {
namespace {

// Bartlett (1946): variance of the estimated autocorrelation at lags where the true one is zero, here of what
// lies beyond the first zero `q`.
double standard_error(const std::vector<double>& r, std::size_t q, std::size_t n) {
  double sum = 1.0;
  for (std::size_t k = 1; k < q; ++k) sum += 2.0 * r[k] * r[k];
  return std::sqrt(sum / static_cast<double>(n));
}

// Highest lag of each stretch above zero that begins and ends within the record, after the first fall below.
std::vector<std::size_t> peaks(const std::vector<double>& r, std::size_t first_zero) {
  std::vector<std::size_t> result;
  std::size_t k = first_zero;
  while (k < r.size()) {
    while (k < r.size() && r[k] <= 0.0) ++k;
    std::size_t best = k;
    for (; k < r.size() && r[k] > 0.0; ++k) {
      if (r[k] > r[best]) best = k;
    }
    if (k < r.size()) result.push_back(best);
  }
  return result;
}

// One peak out of so many is to exceed it by chance in one record out of twenty.
double quantile_for_any_of(std::size_t peaks) {
  return boost::math::quantile(boost::math::normal(), 1.0 - 0.05 / static_cast<double>(peaks));
}

void find_period(const std::vector<double>& load, LoadCycle& cycle, double interval, double speed) {
  const std::vector<double> r = autocorrelation(load, load.size() / 3);
  const std::size_t zero = static_cast<std::size_t>(
      std::find_if(r.begin(), r.end(), [](double value) { return value <= 0.0; }) - r.begin());
  const std::vector<std::size_t> found = peaks(r, zero);
  if (found.empty()) return;
  cycle.significant_above = quantile_for_any_of(found.size()) * standard_error(r, zero, load.size());
  for (const std::size_t lag : found) {
    if (r[lag] <= cycle.significant_above) continue;
    cycle.clear = true;
    cycle.period = static_cast<double>(lag) * interval;
    cycle.advance = cycle.period * speed;
    cycle.height = r[lag];
    cycle.cycles = static_cast<double>(load.size()) / static_cast<double>(lag);
    return;
  }
}

}  // namespace

std::vector<double> autocorrelation(const std::vector<double>& values, std::size_t most) {
  const std::size_t n = values.size();
  double mean = 0.0;
  for (double v : values) mean += v / static_cast<double>(n);
  std::vector<double> r;
  for (std::size_t lag = 0; lag <= most && lag < n; ++lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) sum += (values[i] - mean) * (values[i + lag] - mean);
    if (lag == 0 && !(sum > 0.0)) return {};
    r.push_back(lag == 0 ? sum : sum / r[0]);
  }
  if (!r.empty()) r[0] = 1.0;
  return r;
}

LoadCycle load_cycle(const History& history, double steady_from) {
  LoadCycle cycle;
  std::vector<double> load;
  int idle = 0;
  double speed = 0.0;
  for (const HistoryRow& row : history.rows) {
    if (row.advance <= steady_from) continue;
    load.push_back(-row.F[0]);
    idle += row.contacts == 0 && row.F[0] == 0.0 && row.F[1] == 0.0 && row.F[2] == 0.0;
    speed = row.advance / row.t;
  }
  if (load.empty()) return cycle;
  const double n = static_cast<double>(load.size());
  double mean = 0.0, square = 0.0;
  for (double v : load) mean += v / n;
  for (double v : load) square += (v - mean) * (v - mean) / std::max(1.0, n - 1.0);
  cycle.peak_over_mean = *std::max_element(load.begin(), load.end()) / mean;
  cycle.deviation_over_mean = std::sqrt(square) / mean;
  cycle.without_contact = idle / n;
  find_period(load, cycle, history.interval, speed);
  return cycle;
}

}  // namespace icebow
