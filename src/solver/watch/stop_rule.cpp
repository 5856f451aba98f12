#include "solver/watch/stop_rule.h"

#include <algorithm>
#include <cmath>

namespace icebow {

bool is_look(int steady_samples) {
  int look = first_look;
  while (look < steady_samples) look = static_cast<int>(std::ceil(look * look_growth));
  return look == steady_samples;
}

bool narrow_enough(const LoadStatistics& load, double relative_half_width) {
  return load.effective_samples >= fewest_independent &&
         load.ci95 <= relative_half_width * std::abs(load.mean);
}

bool enough_recorded(const History& history, double steady_from, double relative_half_width) {
  if (!(relative_half_width > 0.0)) return false;
  const auto& rows = history.rows;
  const auto steady = std::partition_point(rows.begin(), rows.end(),
                                           [&](const HistoryRow& row) { return row.advance <= steady_from; });
  if (!is_look(static_cast<int>(rows.end() - steady))) return false;
  std::vector<double> resistance;
  for (auto row = steady; row != rows.end(); ++row) resistance.push_back(-row->F[0]);
  return narrow_enough(series_statistics(resistance), relative_half_width);
}

}  // namespace icebow
