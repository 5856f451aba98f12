// Where a point lies relative to a rigid hull: the fast contact detection (bounding box, candidate planes, signed
// distance). The hull is fixed in its own frame; callers shift the points.
//
// The surface is each quad split into two triangles along its shorter diagonal, so a warped quad is still watertight.
// Signed distance is negative inside; its sign comes from angle-weighted pseudo-normals (Baerentzen and Aanaes 2005),
// right at edges and corners of a closed mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "base/quad_mesh.h"

namespace icebow {

struct ClosestPoint {
  double signed_distance = 0.0;  //!< [m], negative inside
  Vec3 point = Vec3::Zero();     // on the surface
  Vec3 normal = Vec3::Zero();    // outward unit normal there
  int quad = -1;
};

// The reference: every triangle is asked.
class BruteForceDistance;  // internal to hull_distance.cpp; use closest_brute_force
ClosestPoint closest_brute_force(const QuadMesh& mesh, const Vec3& p);

class HullDistance {
 public:
  // Only points in `region` (hull frame) will be asked: panels that can be closest to none of them are dropped.
  HullDistance(const QuadMesh& mesh, const Box& region);

  // False at once (one table look-up) for points that are certainly outside the hull or outside the region.
  bool may_be_inside(const Vec3& p) const;
  // Exact closest point, equal to closest_brute_force for any point of the region inside the hull, and outside it.
  ClosestPoint closest(const Vec3& p) const;
};

}  // namespace icebow
