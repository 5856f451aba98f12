#include "solver/model/drift.h"

#include "solver/model/statistics.h"

namespace icebow {

Drift drift_of(const std::vector<double>& record) {
  const auto middle = record.begin() + static_cast<std::ptrdiff_t>(record.size() / 2);
  const LoadStatistics a = series_statistics({record.begin(), middle}),
                       b = series_statistics({middle, record.end()});
  Drift drift;
  drift.p = 1.0;
  if (a.mean == 0.0) return drift;
  drift.relative = b.mean / a.mean - 1.0;
  drift.p = mean_difference(mean_estimate(a.mean, a.ci95, a.effective_samples),
                            mean_estimate(b.mean, b.ci95, b.effective_samples))
                .p;
  return drift;
}

}  // namespace icebow
