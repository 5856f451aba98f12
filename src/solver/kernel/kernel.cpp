#include "solver/kernel/kernel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/errors.h"
#include "base/units.h"

namespace icebow {

extern const Kernels kernels_baseline;
#ifdef ICEBOW_X86_KERNELS
extern const Kernels kernels_avx2, kernels_avx512;
#endif

const Kernels& baseline_kernels() {
  return kernels_baseline;
}

namespace {

// Those compiled in, the widest first; null where this processor lacks the instructions.
struct Choice {
  const char* name;
  const Kernels* kernels;
};

std::vector<Choice> choices() {
  std::vector<Choice> all;
#ifdef ICEBOW_X86_KERNELS
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  all.push_back({"avx512", avx512 ? &kernels_avx512 : nullptr});
  all.push_back({"avx2", avx2 ? &kernels_avx2 : nullptr});
#endif
  all.push_back({"baseline", &kernels_baseline});
  return all;
}

}  // namespace

const Kernels& kernels_named(const std::string& name) {
  std::string allowed;
  bool known = name.empty();
  for (const Choice& choice : choices()) {
    known |= name == choice.name;
    if (!choice.kernels) continue;
    if (name.empty() || name == choice.name) return *choice.kernels;
    allowed += (allowed.empty() ? "" : ", ") + std::string(choice.name);
  }
  throw InputError("ICEBOW_KERNEL=" + name + ": " +
                   (known ? "this processor lacks its instructions" : "no such vector width") +
                   "; allowed here: " + allowed + ", or leave it unset for the widest");
}

const Kernels& kernels() {
  static const Kernels& chosen = [&]() -> const Kernels& {
    const char* const name = std::getenv("ICEBOW_KERNEL");
    return kernels_named(name ? name : "");
  }();
  return chosen;
}

namespace {

// Polynomial through the function's values at the Chebyshev points of [lower, upper]: near the best one of
// its degree. Solved in the scaled variable t in [-1, 1], where the powers are well conditioned, then
// expanded.
template <int n, class Real, class Function>
void fit(Function f, double lower, double upper, Real (&coefficients)[n]) {
  using Matrix = Eigen::Matrix<long double, n, n>;
  using Vector = Eigen::Matrix<long double, n, 1>;
  const long double middle = 0.5L * (lower + upper), half = 0.5L * (upper - lower);
  Matrix powers;
  Vector values;
  for (int i = 0; i < n; ++i) {
    const long double t = std::cos(static_cast<long double>(pi) * (i + 0.5L) / n);
    for (int p = 0; p < n; ++p) powers(i, p) = std::pow(t, p);
    values(i) = f(middle + half * t);
  }
  const Vector scaled = powers.fullPivLu().solve(values);
  // Horner's scheme with the polynomial t(e) = (e - middle) / half.
  long double expanded[n] = {};
  for (int p = n - 1; p >= 0; --p) {
    for (int power = n - 1; power >= 0; --power) {
      expanded[power] = ((power ? expanded[power - 1] : 0.0L) - middle * expanded[power]) / half;
    }
    expanded[0] += scaled(p);
  }
  for (int p = 0; p < n; ++p) coefficients[p] = static_cast<Real>(expanded[p]);
}

template <class Real, int degree>
LawFits<Real, degree> fits(double lower, double upper) {
  LawFits<Real, degree> law;
  const auto root = [](long double e) { return std::sqrt(1.0L + e); };
  fit([&](long double e) { return 2.0L / (1.0L + root(e)); }, lower, upper, law.G);
  fit([&](long double e) { return 1.0L / root(e); }, lower, upper, law.R);
  fit([&](long double e) { return 2.0L / (root(e) * (1.0L + root(e))); }, lower, upper, law.H);
  return law;
}

}  // namespace

namespace {

constexpr double never = 1e6;  // no bond is stretched so far

// Taylor series at e = 0 over its first term, of G, R and H.
template <class Real, int degree>
LawFits<Real, degree> calm_series() {
  constexpr double G[3] = {1.0, -1.0 / 4.0, 1.0 / 8.0}, R[3] = {1.0, -1.0 / 2.0, 3.0 / 8.0},
                   H[3] = {1.0, -3.0 / 4.0, 5.0 / 8.0};
  static_assert(degree < 3);
  LawFits<Real, degree> law;
  for (int p = 0; p <= degree; ++p) {
    law.G[p] = static_cast<Real>(G[p]);
    law.R[p] = static_cast<Real>(R[p]);
    law.H[p] = static_cast<Real>(H[p]);
  }
  return law;
}

}  // namespace

template <class Real>
BondLaw<Real> make_bond_law(const Material& m) {
  using Degrees = LawDegrees<Real>;
  constexpr double shortest = -0.19;  // 10 % shorter
  constexpr double longest = 0.05;    // bonds that contact holds together may stretch further than s0
  BondLaw<Real> law;
  const double e_break = m.s0 * (2.0 + m.s0);
  law.stress_per_stretch = law.stress_per_theta = 0;
  law.e_break = static_cast<Real>(e_break);
  if (m.tensile_strength > 0.0) {
    law.stress_per_stretch = static_cast<Real>(m.normal_stress(1.0, 0.0) / m.tensile_strength);
    law.stress_per_theta = static_cast<Real>(m.normal_stress(0.0, 0.5) / m.tensile_strength);
    law.e_break = static_cast<Real>(never);
  }
  const double e_max = std::max(e_break, longest);
  law.wide = fits<Real, Degrees::wide>(shortest, e_max);
  law.small = fits<Real, Degrees::small>(-bent_strain, bent_strain);
  law.e_min = static_cast<Real>(shortest);
  law.e_max = static_cast<Real>(e_max);
  law.e_small = static_cast<Real>(bent_strain);
  law.calm = calm_series<Real, Degrees::calm>();
  law.e_calm = static_cast<Real>(calm_strain);
  return law;
}

template BondLaw<float> make_bond_law<float>(const Material&);
template BondLaw<double> make_bond_law<double>(const Material&);

}  // namespace icebow
