// Whether a load comes in cycles, and how regular they are. docs/theory.md, "The breaking process".
#pragma once

#include <vector>

#include "solver/model/breaking_process.h"
#include "solver/model/history.h"

namespace icebow {

// Looks at the resistance from the advance `steady_from` [m] on, up to a third of the record's length:
// a period must fit three times.
LoadCycle load_cycle(const History& history, double steady_from);

// Autocorrelation of a series at the lags 0 .. most; 1 at lag 0. Empty where the series is constant.
std::vector<double> autocorrelation(const std::vector<double>& values, std::size_t most);

}  // namespace icebow
