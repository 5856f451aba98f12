#include "geometry/triangles.h"

#include <algorithm>

namespace icebow {

std::vector<std::array<int, 3>> triangles(const QuadMesh& mesh) {
  std::vector<std::array<int, 3>> result;
  result.reserve(2 * mesh.quads.size());
  const auto& p = mesh.points;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    const auto& q = mesh.quads[k];
    if (mesh.is_triangle(k)) {
      result.push_back({q[0], q[1], q[2]});
    } else if ((p[q[0]] - p[q[2]]).squaredNorm() <= (p[q[1]] - p[q[3]]).squaredNorm()) {
      result.push_back({q[0], q[1], q[2]});
      result.push_back({q[0], q[2], q[3]});
    } else {
      result.push_back({q[1], q[2], q[3]});
      result.push_back({q[1], q[3], q[0]});
    }
  }
  return result;
}

std::pair<int, int> contact_diagonal(const QuadMesh& mesh, std::size_t quad) {
  const auto& q = mesh.quads[quad];
  const auto& p = mesh.points;
  const bool first = (p[q[0]] - p[q[2]]).squaredNorm() <= (p[q[1]] - p[q[3]]).squaredNorm();
  return first ? std::minmax(q[0], q[2]) : std::minmax(q[1], q[3]);
}

}  // namespace icebow
