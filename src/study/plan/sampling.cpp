#include "study/plan/sampling.h"

namespace icebow {

std::vector<std::vector<double>> full_factorial(const std::vector<std::vector<double>>& levels) {
  std::vector<std::vector<double>> points = {{}};
  for (const std::vector<double>& axis : levels) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& point : points) {
      for (const double value : axis) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<double> equally_spaced(double lower, double upper, int levels) {
  std::vector<double> values;
  for (int i = 0; i < levels; ++i) {
    const double t = levels > 1 ? static_cast<double>(i) / (levels - 1) : 0.0;
    values.push_back((1.0 - t) * lower + t * upper);
  }
  return values;
}

}  // namespace icebow
