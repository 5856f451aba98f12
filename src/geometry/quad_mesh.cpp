#include "geometry/quad_mesh.h"

#include <Eigen/Geometry>

namespace icebow {

Box bounding_box(const QuadMesh& mesh) {
  Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
  for (const Vec3& p : mesh.points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

QuadMesh scaled(const QuadMesh& mesh, double factor) {
  QuadMesh result = mesh;
  for (Vec3& p : result.points) p *= factor;
  return result;
}

double enclosed_volume(const QuadMesh& mesh) {
  double six_volumes = 0.0;
  for (const auto& q : mesh.quads) {
    const Vec3 &a = mesh.points[q[0]], &b = mesh.points[q[1]], &c = mesh.points[q[2]], &d = mesh.points[q[3]];
    six_volumes += a.dot(b.cross(c)) + a.dot(c.cross(d));
  }
  return six_volumes / 6.0;
}

}  // namespace icebow
