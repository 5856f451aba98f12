// Points by cubic cells of a box, to find those near a place. Points outside the box count as in its nearest
// cell: what is near to each other stays in the same or in neighbouring cells.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace icebow {

class PointCells {
 public:
  // `edge` of a cell [m].
  PointCells(const std::vector<Vec3>& points, const Vec3& lower, const Vec3& upper, double edge);

  // visit(n) for every point nearer than `edge` to a place, itself included.
  template <class Visit>
  void for_each_near(const Vec3& place, Visit visit) const {
    const int x = cell(place, 0), y = cell(place, 1), z = cell(place, 2);
    for (int iz = std::max(z - 1, 0); iz <= std::min(z + 1, n_[2] - 1); ++iz) {
      for (int iy = std::max(y - 1, 0); iy <= std::min(y + 1, n_[1] - 1); ++iy) {
        // Cells side by side along x follow each other.
        const std::size_t row = (std::size_t(iz) * n_[1] + iy) * n_[0];
        const std::uint32_t end = start_[row + std::min(x + 1, n_[0] - 1) + 1];
        for (std::uint32_t m = start_[row + std::max(x - 1, 0)]; m < end; ++m) {
          if ((sorted_[m].position - place).squaredNorm() < edge_ * edge_) visit(sorted_[m].number);
        }
      }
    }
  }

 private:
  struct Point {
    Vec3 position;
    int number;
  };
  int cell(const Vec3& p, int c) const {
    // Clamped before it is converted: a particle may have been thrown anywhere, and NaN becomes 0.
    return static_cast<int>(std::max(0.0, std::min(n_[c] - 1.0, (p[c] - lower_[c]) / edge_)));
  }
  std::size_t number(const Vec3& p) const {
    return (std::size_t(cell(p, 2)) * n_[1] + cell(p, 1)) * n_[0] + cell(p, 0);
  }

  Vec3 lower_;
  double edge_;
  int n_[3];
  std::vector<std::uint32_t> start_;  // [cell]: its first in sorted_
  std::vector<Point> sorted_;
};

}  // namespace icebow
