// Mean of a correlated series and how far to trust it; correlation of ranks.
//
// For finite values no statistic of a series is NaN: a series too short for an interval has an infinite one,
// a constant series has ci95 = 0.
#pragma once

#include <vector>

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

// Spearman's rank correlation: Pearson's of the ranks, equal values sharing the average of their ranks
// (Kendall and Gibbons 1990). NaN for fewer than two pairs or where one series is constant.
double spearman_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace icebow
