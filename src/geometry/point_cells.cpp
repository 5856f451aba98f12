#include "geometry/point_cells.h"

namespace icebow {

PointCells::PointCells(const std::vector<Vec3>& points, const Vec3& lower, const Vec3& upper, double edge)
    : lower_(lower), edge_(edge) {
  std::size_t cells = 1;
  for (int c = 0; c < 3; ++c) {
    n_[c] = std::max(1, static_cast<int>((upper[c] - lower[c]) / edge));
    cells *= n_[c];
  }
  start_.assign(cells + 1, 0);
  for (const Vec3& p : points) ++start_[number(p) + 1];
  for (std::size_t n = 0; n < cells; ++n) start_[n + 1] += start_[n];
  sorted_.resize(points.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t n = 0; n < points.size(); ++n)
    sorted_[next[number(points[n])]++] = {points[n], static_cast<int>(n)};
}

}  // namespace icebow
