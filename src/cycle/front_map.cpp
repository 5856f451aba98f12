#include "cycle/front_map.h"

#include <algorithm>
#include <cmath>

namespace icebow::cycle {
namespace {

// A panel whose normal is nearer than this to square across the course has no front: it is seen edge-on.
constexpr double least_forward = 1e-6;

struct Span {
  double z[2], x[2];
  int points = 0;
  void add(double at_z, double at_x) {
    if (points < 2)
      z[points] = at_z, x[points] = at_x, ++points;
    else if (at_z < z[0])
      z[0] = at_z, x[0] = at_x;
    else if (at_z > z[1])
      z[1] = at_z, x[1] = at_x;
    if (points == 2 && z[0] > z[1]) std::swap(z[0], z[1]), std::swap(x[0], x[1]);
  }
};

// The part of an edge in the plane y: one point, both ends, or nothing.
void cut(const Vec3& from, const Vec3& to, double y, Span& span) {
  const double low = std::min(from.y(), to.y()), high = std::max(from.y(), to.y());
  if (y < low || y > high) return;
  if (high == low) {
    span.add(from.z(), from.x());
    span.add(to.z(), to.x());
    return;
  }
  const double t = (y - from.y()) / (to.y() - from.y());
  span.add(from.z() + t * (to.z() - from.z()), from.x() + t * (to.x() - from.x()));
}

}  // namespace

FrontMap::FrontMap(const QuadMesh& hull, std::vector<double> ys, double z0, double dz, int rows)
    : ys_(std::move(ys)), z0_(z0), dz_(dz), rows_(rows) {
  x_.assign(ys_.size() * static_cast<std::size_t>(rows_), none);
  slope_y_.assign(x_.size(), 0.0);
  for (std::size_t q = 0; q < hull.quads.size(); ++q) {
    const auto& quad = hull.quads[q];
    const auto point = [&](int k) -> const Vec3& {
      return hull.points[static_cast<std::size_t>(quad[static_cast<std::size_t>(k)])];
    };
    draw(point(0), point(1), point(2));
    if (!hull.is_triangle(q)) draw(point(0), point(2), point(3));
  }
}

void FrontMap::draw(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.x() <= least_forward * normal.norm()) return;
  const double highest = std::max({a.z(), b.z(), c.z()}), lowest = std::min({a.z(), b.z(), c.z()});
  if (highest < z0_ - dz_ || lowest > z(rows_)) return;
  const auto first = std::lower_bound(ys_.begin(), ys_.end(), std::min({a.y(), b.y(), c.y()}));
  const auto last = std::upper_bound(ys_.begin(), ys_.end(), std::max({a.y(), b.y(), c.y()}));
  for (auto column = first; column < last; ++column)
    draw_column(static_cast<int>(column - ys_.begin()), a, b, c, normal.y() / normal.x());
}

void FrontMap::draw_column(int column, const Vec3& a, const Vec3& b, const Vec3& c, double slope) {
  Span span;
  cut(a, b, y(column), span);
  cut(b, c, y(column), span);
  cut(c, a, y(column), span);
  if (span.points < 2) return;
  const double rounding = 1e-9 * dz_;  // a row along the seam of two panels belongs to both
  const int from = std::max(0, static_cast<int>(std::ceil((span.z[0] - z0_ - rounding) / dz_)));
  const int to = std::min(rows_ - 1, static_cast<int>(std::floor((span.z[1] - z0_ + rounding) / dz_)));
  const double height = span.z[1] - span.z[0];
  for (int row = from; row <= to; ++row) {
    const double t = height > 0.0 ? std::clamp((z(row) - span.z[0]) / height, 0.0, 1.0) : 0.5;
    const double x = span.x[0] + t * (span.x[1] - span.x[0]);
    double& foremost = x_[index(column, row)];
    if (x <= foremost) continue;
    foremost = x;
    slope_y_[index(column, row)] = slope;
  }
}

}  // namespace icebow::cycle
