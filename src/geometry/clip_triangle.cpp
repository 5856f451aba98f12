#include "geometry/clip_triangle.h"

#include <algorithm>

namespace icebow {
namespace {

// Keeps what lies at sign * x[axis] <= sign * limit.
void keep(Polygon& polygon, int axis, double limit, double sign) {
  double excess[9];
  bool cut = false;
  for (int k = 0; k < polygon.size; ++k) {
    excess[k] = sign * (polygon.corner[k][axis] - limit);
    cut = cut || excess[k] > 0.0;
  }
  if (!cut) return;
  const Polygon whole = polygon;
  polygon.size = 0;
  for (int k = 0; k < whole.size; ++k) {
    const int next = k + 1 < whole.size ? k + 1 : 0;
    const Vec3 &from = whole.corner[k], &to = whole.corner[next];
    if (excess[k] <= 0.0) polygon.corner[polygon.size++] = from;
    if ((excess[k] < 0.0 && excess[next] > 0.0) || (excess[k] > 0.0 && excess[next] < 0.0))
      polygon.corner[polygon.size++] = from + excess[k] / (excess[k] - excess[next]) * (to - from);
  }
}

}  // namespace

double Polygon::lower(int axis) const {
  double result = corner[0][axis];
  for (int k = 1; k < size; ++k) result = std::min(result, corner[k][axis]);
  return result;
}

double Polygon::upper(int axis) const {
  double result = corner[0][axis];
  for (int k = 1; k < size; ++k) result = std::max(result, corner[k][axis]);
  return result;
}

void clip(Polygon& polygon, int axis, double from, double to) {
  keep(polygon, axis, to, 1.0);
  keep(polygon, axis, from, -1.0);
}

double area(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (int k = 2; k < polygon.size; ++k)
    sum += (polygon.corner[k - 1] - polygon.corner[0]).cross(polygon.corner[k] - polygon.corner[0]);
  return 0.5 * sum.norm();
}

}  // namespace icebow
