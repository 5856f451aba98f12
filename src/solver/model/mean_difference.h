// Whether two means differ: Welch's test [Welch1947] on what each mean is worth.
//
// A mean of a correlated series is worth as many independent samples as its autocorrelation leaves
// (statistics.h); a mean of repeated runs as many as there are runs.
#pragma once

namespace icebow {

struct MeanEstimate {
  double mean = 0.0;                //!< [N]
  double standard_error = 0.0;      //!< of the mean [N]; infinite = not known, 0 = exact
  double degrees_of_freedom = 0.0;  // of the standard error; infinite = known exactly
};

// From the half width of a mean's 95 % interval (Student's t) and the independent samples it is made of.
// Fewer than two samples, or a half width that is no finite number: the standard error is infinite.
MeanEstimate mean_estimate(double mean, double ci95, double samples);

struct MeanDifference {
  double difference = 0.0;  //!< b - a [N]
  double ci95 = 0.0;        //!< half width of its 95 % interval [N]; infinite where an error is not known
  double p = 1.0;           // two-sided: how often equal means would look so unlike
};

// Unequal variances, Welch's and Satterthwaite's degrees of freedom.
MeanDifference mean_difference(const MeanEstimate& a, const MeanEstimate& b);

// One-sided: b - a is not larger than this [N], but with a probability of `level`. Infinite where an error is
// not known.
double most_difference(const MeanEstimate& a, const MeanEstimate& b, double level);

constexpr double told_apart_below = 0.05;  // of p

}  // namespace icebow
