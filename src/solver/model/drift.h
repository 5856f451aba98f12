// Whether a load record still drifts where its mean is taken.
#pragma once

#include <limits>
#include <vector>

#include "solver/model/mean_difference.h"

namespace icebow {

struct Drift {
  double relative = std::numeric_limits<double>::quiet_NaN();  // second half over first half, minus 1
  // How often halves of one mean would look so unlike (solver/model/mean_difference.h); NaN: not tested.
  double p = std::numeric_limits<double>::quiet_NaN();
  bool told() const { return p < told_apart_below; }
};

// Of a record that is equally spaced in time; each half is worth the independent samples that its
// autocorrelation leaves. p is 1 where there are too few of them.
Drift drift_of(const std::vector<double>& record);

}  // namespace icebow
