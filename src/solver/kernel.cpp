#include "solver/kernel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace icebow {

extern const Kernels kernels_baseline;
#ifdef ICEBOW_X86_KERNELS
extern const Kernels kernels_avx2, kernels_avx512;
#endif

const Kernels& baseline_kernels() {
  return kernels_baseline;
}

const Kernels& kernels() {
#ifdef ICEBOW_X86_KERNELS
  static const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  static const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx512) return kernels_avx512;
  if (avx2) return kernels_avx2;
#endif
  return kernels_baseline;
}

namespace {

// Polynomial through the function's values at the Chebyshev points of [lower, upper]: near the best one of
// its degree.
template <int n, class Function>
void fit(Function f, double lower, double upper, float (&coefficients)[n]) {
  Eigen::Matrix<double, n, n> powers;
  Eigen::Matrix<double, n, 1> values;
  for (int i = 0; i < n; ++i) {
    const double e = 0.5 * (lower + upper) + 0.5 * (upper - lower) * std::cos(pi * (i + 0.5) / n);
    for (int p = 0; p < n; ++p) powers(i, p) = std::pow(e, p);
    values(i) = f(e);
  }
  const Eigen::Matrix<double, n, 1> solution = powers.fullPivLu().solve(values);
  for (int p = 0; p < n; ++p) coefficients[p] = static_cast<float>(solution(p));
}

template <int degree>
LawFits<degree> fits(double lower, double upper) {
  LawFits<degree> law;
  const auto root = [](double e) { return std::sqrt(1.0 + e); };
  fit([&](double e) { return 1.0 / (1.0 + root(e)); }, lower, upper, law.G);
  fit([&](double e) { return 1.0 / root(e); }, lower, upper, law.R);
  fit([&](double e) { return 1.0 / (root(e) * (1.0 + root(e))); }, lower, upper, law.H);
  return law;
}

}  // namespace

BondLaw make_bond_law(double s0) {
  constexpr double shortest = -0.19;       // 10 % shorter
  constexpr double widest_small = 0.0125;  // where degree 2 is still good to 1e-6
  BondLaw law;
  const double e_break = s0 * (2.0 + s0), e_small = std::min(e_break, widest_small);
  law.wide = fits<law_degree>(shortest, e_break);
  law.small = fits<small_law_degree>(-e_small, e_small);
  law.e_min = static_cast<float>(shortest);
  law.e_break = static_cast<float>(e_break);
  law.e_small = static_cast<float>(e_small);
  return law;
}

}  // namespace icebow
