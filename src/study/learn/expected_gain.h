// What one more evaluation is expected to gain, as logarithms: far from the best they are too small for a
// double.
#pragma once

namespace icebow {

// ln of the expected improvement of N(mean, sd^2) below `target` [Jones1998, eq. 15]:
//   E[max(target - Y, 0)] = (target - mean) Phi(z) + sd phi(z),   z = (target - mean) / sd        (1)
// -infinity where sd is 0 and mean is not below target.
double log_expected_improvement(double target, double mean, double sd);

// ln of the factor that makes (1) the augmented expected improvement [Huang2006]: one more noisy value tells
// less where the model is surer than the value itself.
//   1 - t / sqrt(sd^2 + t^2),   t^2 the variance of one value's noise                            (2)
double log_worth_of_noisy(double sd, double noise_variance);

// ln of the probability that N(mean, sd^2) is 0 or more.
double log_probability_kept(double mean, double sd);

}  // namespace icebow
