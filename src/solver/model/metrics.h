// The numbers a run is judged by. Model scale (the scale of the run).
#pragma once

#include <cstdint>

#include "solver/model/drift.h"
#include "solver/model/statistics.h"

namespace icebow {

struct Metrics {
  LoadStatistics resistance;                  // -Fx
  LoadStatistics vertical;                    // Fz
  Drift drift;                                // of the resistance
  double steady_from = 0.0, steady_to = 0.0;  //!< advance [m]
  std::int64_t broken_bonds = 0;              // each bond once
  std::int64_t bonds = 0;                     // in the reference configuration
  double mean_damage = 0.0;  // broken / initial bonds, mean over the particles the ship met; NaN: it met none
  double channel_width = 0.0;  //!< mean over stations [m]
  double channel_width_over_beam = 0.0;
  double crushed_volume = 0.0;  //!< in pieces smaller than (2h)^2 h [m^3]
  double broken_volume = 0.0;   //!< detached from the standing sheet, crushed included [m^3]
  int floes = 0;                // detached pieces of at least (2h)^2 h
};

}  // namespace icebow
