#include "tests/support/bow_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace icebow {
namespace {

Row row(const QuadMesh& mesh, int along, const std::function<bool(const Vec3&)>& belongs) {
  Row points;
  std::vector<char> seen(mesh.points.size(), 0);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    if (mesh.patch[k] != Patch::bow) continue;
    for (const int corner : mesh.quads[k]) {
      const Vec3& p = mesh.points[corner];
      if (seen[corner] || !belongs(p)) continue;
      seen[corner] = 1;
      points.push_back({p[along], -p.x()});
    }
  }
  std::sort(points.begin(), points.end(),
            [](const RowPoint& a, const RowPoint& b) { return a.along < b.along; });
  return points;
}

}  // namespace

Row waterline_row(const QuadMesh& mesh) {
  return row(mesh, 1, [](const Vec3& p) { return std::abs(p.z()) < 1e-9 && p.y() > -1e-9; });  // [m] rounding
}
Row buttock_row(const QuadMesh& mesh, double y) {
  return row(mesh, 2, [y](const Vec3& p) { return std::abs(p.y() - y) < 1e-9; });  // [m] rounding
}

}  // namespace icebow
