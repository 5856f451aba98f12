// How often the load is recorded.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/units.h"

namespace icebow {

// Seconds between samples: 1/12.5 of sqrt(h/g), the time scale of a floating sheet; 5 ms for a 40 mm sheet.
inline double sampling_interval(double h) {
  return 0.08 * std::sqrt(h / gravity);
}
inline std::int64_t sampling_steps(double h, double dt) {
  return std::max<std::int64_t>(1, std::llround(sampling_interval(h) / dt));
}

}  // namespace icebow
