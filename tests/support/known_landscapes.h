// Functions whose smallest value is known, for searches: Branin, Hartmann with 3 and 6 variables.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace icebow {

// x[0] from -5 to 10, x[1] from 0 to 15; smallest at three points.
inline double branin(const std::vector<double>& x) {
  const double a = x[1] - 5.1 / (4.0 * M_PI * M_PI) * x[0] * x[0] + 5.0 / M_PI * x[0] - 6.0;
  return a * a + 10.0 * (1.0 - 1.0 / (8.0 * M_PI)) * std::cos(x[0]) + 10.0;
}
constexpr double least_branin = 0.397887;

template <std::size_t d>
double hartmann(const std::vector<double>& x, const double (&a)[4][d], const double (&p)[4][d]) {
  constexpr double weights[4] = {1.0, 1.2, 3.0, 3.2};
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double inner = 0.0;
    for (std::size_t k = 0; k < d; ++k) inner += a[i][k] * (x[k] - p[i][k]) * (x[k] - p[i][k]);
    sum -= weights[i] * std::exp(-inner);
  }
  return sum;
}

// In the unit cube.
inline double hartmann3(const std::vector<double>& x) {
  static const double a[4][3] = {{3, 10, 30}, {0.1, 10, 35}, {3, 10, 30}, {0.1, 10, 35}};
  static const double p[4][3] = {
      {0.3689, 0.1170, 0.2673}, {0.4699, 0.4387, 0.7470}, {0.1091, 0.8732, 0.5547}, {0.0381, 0.5743, 0.8828}};
  return hartmann(x, a, p);
}
constexpr double least_hartmann3 = -3.86278;

inline double hartmann6(const std::vector<double>& x) {
  static const double a[4][6] = {{10, 3, 17, 3.5, 1.7, 8},
                                 {0.05, 10, 17, 0.1, 8, 14},
                                 {3, 3.5, 1.7, 10, 17, 8},
                                 {17, 8, 0.05, 10, 0.1, 14}};
  static const double p[4][6] = {{0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886},
                                 {0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991},
                                 {0.2348, 0.1451, 0.3522, 0.2883, 0.3047, 0.6650},
                                 {0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381}};
  return hartmann(x, a, p);
}
constexpr double least_hartmann6 = -3.32237;

// Normal noise that is the same on every machine (Box and Muller).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}
  double operator()() {
    const double u = uniform(), v = uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * M_PI * v);
  }
  double uniform() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

}  // namespace icebow
