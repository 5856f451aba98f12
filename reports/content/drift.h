// Whether a load record still drifts where its mean is taken.
#pragma once

#include "reports/content/history_file.h"
#include "solver/model/mean_difference.h"

namespace icebow {

struct Drift {
  double relative = 0.0;  // second half over first half, minus 1
  double p = 1.0;         // of equal halves (solver/model/mean_difference.h)
  bool told() const { return p < told_apart_below; }
};

// The drift over the samples from `from` to `to` [m, as the series' advance]; equally spaced in time. p is 1
// where there are too few.
Drift drift_of(const LoadSeries& series, double from, double to);

}  // namespace icebow
