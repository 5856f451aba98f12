#include "reports/content/drift.h"

#include <cmath>

#include "solver/model/statistics.h"

namespace icebow {

Drift drift_of(const LoadSeries& series, double from, double to) {
  std::vector<double> first, second;
  for (std::size_t i = 0; i < series.load.size(); ++i) {
    const double at = series.advance[i];
    if (at >= from && at <= to) (at < 0.5 * (from + to) ? first : second).push_back(series.load[i]);
  }
  const LoadStatistics a = series_statistics(first), b = series_statistics(second);
  Drift drift;
  if (a.mean == 0.0) return drift;
  drift.relative = b.mean / a.mean - 1.0;
  drift.p = mean_difference(mean_estimate(a.mean, a.ci95, a.effective_samples),
                            mean_estimate(b.mean, b.ci95, b.effective_samples))
                .p;
  return drift;
}

}  // namespace icebow
