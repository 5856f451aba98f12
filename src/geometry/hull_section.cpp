#include "geometry/hull_section.h"

namespace icebow {
namespace {

void cut_triangle(const Vec3& a, const Vec3& b, const Vec3& c, double z, std::vector<Segment>& segments) {
  const Vec3* corner[3] = {&a, &b, &c};
  Vec2 cut[2];
  int cuts = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 *from = corner[k], *to = corner[(k + 1) % 3];
    if ((from->z() >= z) == (to->z() >= z)) continue;
    if (from->z() >= z) std::swap(from, to);  // the same arithmetic for both triangles of an edge
    const double share = (z - from->z()) / (to->z() - from->z());
    cut[cuts++] = (*from + share * (*to - *from)).head<2>();
  }
  if (cuts == 2) segments.emplace_back(cut[0], cut[1]);
}

}  // namespace

std::vector<Segment> hull_section(const QuadMesh& hull, double z) {
  std::vector<Segment> segments;
  for (const auto& q : hull.quads) {
    const Vec3 &a = hull.points[q[0]], &b = hull.points[q[1]], &c = hull.points[q[2]], &d = hull.points[q[3]];
    cut_triangle(a, b, c, z, segments);
    if (q[2] != q[3]) cut_triangle(a, c, d, z, segments);
  }
  return segments;
}

}  // namespace icebow
