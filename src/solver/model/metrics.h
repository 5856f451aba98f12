// The numbers a run is judged by. Model scale (the scale of the run).
#pragma once

#include <cstdint>
#include <vector>

#include "solver/model/history.h"

namespace icebow {

// Statistics of a correlated series over its steady part.
struct LoadStatistics {
  double mean = 0.0;                //!< [N]
  double ci95 = 0.0;                //!< half width of the 95 % confidence interval of the mean [N]
  double max = 0.0;                 //!< [N]
  double q95 = 0.0;                 //!< 95 % quantile [N]
  double standard_deviation = 0.0;  //!< [N]
  double effective_samples = 0.0;   // independent samples the series is worth
  int samples = 0;
};

// ci95 from the integrated autocorrelation time (and Student's t with the effective number of samples).
// Values must be equally spaced in time. Fewer than 8 values: ci95 is infinite.
LoadStatistics series_statistics(const std::vector<double>& values);

// Half width of the 95 % confidence interval of the mean of independent values (the means of repeated runs):
// Student's t of their scatter. Infinite for fewer than two.
double interval_of_repeats(const std::vector<double>& values);

struct Metrics {
  LoadStatistics resistance;                  // -Fx
  LoadStatistics vertical;                    // Fz
  double steady_from = 0.0, steady_to = 0.0;  //!< advance [m]
  std::int64_t broken_bonds = 0;              // each bond once
  std::int64_t bonds = 0;                     // in the reference configuration
  double mean_damage = 0.0;                   // broken / initial bonds, mean over the particles the ship met
  double channel_width = 0.0;                 //!< mean over stations [m]
  double channel_width_over_beam = 0.0;
  double crushed_volume = 0.0;  //!< in pieces smaller than (2h)^2 h [m^3]
  double broken_volume = 0.0;   //!< detached from the standing sheet, crushed included [m^3]
  int floes = 0;                // detached pieces of at least (2h)^2 h
};

}  // namespace icebow
