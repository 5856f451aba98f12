// Panels with any number of corners, as mesh files have them.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

struct PolygonMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;  // of three corners at least
  std::vector<Patch> patch;                // one per polygon
};

}  // namespace icebow
