// A quad mesh as triangles.
#pragma once

#include <array>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Each quad split along its shorter diagonal, as contact detection does (geometry/hull_distance.h).
std::vector<std::array<int, 3>> triangles(const QuadMesh& mesh);

}  // namespace icebow
