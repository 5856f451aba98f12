#include "hullgen/bow/spacing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace icebow {

std::vector<double> graded(const Curve& curve, double u0, double u1, const CellLength& cell, int min_cells) {
  constexpr int samples = 2000;
  std::vector<double> u(samples + 1), cells(samples + 1, 0.0);  // cells: wanted number of cells up to here
  double length = 0.0;
  Vec3 previous = curve(u0);
  u[0] = u0;
  for (int k = 1; k <= samples; ++k) {
    u[k] =
        u0 + (u1 - u0) * 0.5 * (1.0 - std::cos(pi * k / samples));  // denser where the curve may be vertical
    const Vec3 point = curve(u[k]);
    const double step = (point - previous).norm();
    cells[k] = cells[k - 1] + step / cell(0.5 * (u[k] + u[k - 1]), length + 0.5 * step);
    length += step;
    previous = point;
  }
  const int n = std::max(min_cells, static_cast<int>(std::lround(cells.back())));
  std::vector<double> lines{u0};
  for (int i = 1, k = 1; i < n; ++i) {
    const double wanted = cells.back() * i / n;
    while (cells[k] < wanted) ++k;
    lines.push_back(u[k - 1] + (u[k] - u[k - 1]) * (wanted - cells[k - 1]) / (cells[k] - cells[k - 1]));
  }
  lines.push_back(u1);
  return lines;
}

double curvature_radius(const Curve& curve, double u0, double u1, double u) {
  const double low = std::min(u0, u1), high = std::max(u0, u1), step = 1e-3 * (high - low);
  const double middle = std::clamp(u, low + step, high - step);
  const Vec3 a = curve(middle - step), b = curve(middle), c = curve(middle + step);
  // Radius of the circle through the three points: product of the sides over four times the area.
  const double four_areas = 2.0 * (b - a).cross(c - a).norm();
  return (b - a).norm() * (c - b).norm() * (c - a).norm() / four_areas;
}

}  // namespace icebow
