#include "study/learn/expected_gain.h"

#include <cmath>
#include <limits>

namespace icebow {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double half_log_of_2_pi = 0.91893853320467274;
constexpr double far_out = -20.0;  // beyond it the closed forms cancel, or vanish

double normal_density(double z) {
  return std::exp(-0.5 * z * z - half_log_of_2_pi);
}

double normal_probability(double z) {
  return 0.5 * std::erfc(-z * M_SQRT1_2);
}

// ln of Phi(z) and of phi(z) + z Phi(z) for large negative z: Abramowitz and Stegun 26.2.12, to three terms.
double log_tail(double z) {
  const double q = 1.0 / (z * z);
  return -0.5 * z * z - half_log_of_2_pi - std::log(-z) + std::log1p(-q * (1.0 - 3.0 * q * (1.0 - 5.0 * q)));
}
double log_gain_far_out(double z) {
  const double q = 1.0 / (z * z);
  return -0.5 * z * z - half_log_of_2_pi - 2.0 * std::log(-z) + std::log1p(-3.0 * q * (1.0 - 5.0 * q));
}

}  // namespace

double log_expected_improvement(double target, double mean, double sd) {
  if (!(sd > 0.0)) return mean < target ? std::log(target - mean) : nothing;
  const double z = (target - mean) / sd;
  if (z < far_out) return std::log(sd) + log_gain_far_out(z);
  return std::log(sd) + std::log(normal_density(z) + z * normal_probability(z));
}

double log_worth_of_noisy(double sd, double noise_variance) {
  if (!(noise_variance > 0.0)) return 0.0;
  const double whole = std::sqrt(sd * sd + noise_variance), noise = std::sqrt(noise_variance);
  const double worth = sd * sd / (whole * (whole + noise));  // (2), without its cancellation
  return worth > 0.0 ? std::log(worth) : nothing;
}

double log_probability_kept(double mean, double sd) {
  if (!(sd > 0.0)) return mean >= 0.0 ? 0.0 : nothing;
  const double z = mean / sd;
  return z < far_out ? log_tail(z) : std::log(normal_probability(z));
}

}  // namespace icebow
