// The hull as the ice ahead sees it: x of its foremost surface over the plane across the course.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow::cycle {

// Samples at columns y and rows z = z0 + row dz. Where no panel faces forward the sample is `none`.
class FrontMap {
 public:
  static constexpr double none = -1e30;

  // `ys` ascending [m]. Panels seen from behind or edge-on are left out: ice ahead never meets them.
  FrontMap(const QuadMesh& hull, std::vector<double> ys, double z0, double dz, int rows);

  int columns() const { return static_cast<int>(ys_.size()); }
  int rows() const { return rows_; }
  double y(int column) const { return ys_[static_cast<std::size_t>(column)]; }
  double z(int row) const { return z0_ + row * dz_; }
  double dz() const { return dz_; }

  double x(int column, int row) const { return x_[index(column, row)]; }
  bool reaches(int column, int row) const { return x(column, row) > none; }
  // The samples of a column, upwards.
  const double* column(int i) const { return x_.data() + index(i, 0); }
  // -dx/dy of the foremost panel there: n_y / n_x of its outward normal.
  double slope_y(int column, int row) const { return slope_y_[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
  }
  void draw(const Vec3& a, const Vec3& b, const Vec3& c);
  void draw_column(int column, const Vec3& a, const Vec3& b, const Vec3& c, double slope);

  std::vector<double> ys_;
  double z0_, dz_;
  int rows_;
  std::vector<double> x_, slope_y_;
};

}  // namespace icebow::cycle
