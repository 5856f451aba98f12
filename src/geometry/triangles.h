// A quad mesh as triangles.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Each quad split along its shorter diagonal, as contact detection does (geometry/hull_distance.h).
std::vector<std::array<int, 3>> triangles(const QuadMesh& mesh);

// The ends of the diagonal along which a quad is split, the lower point first.
std::pair<int, int> contact_diagonal(const QuadMesh& mesh, std::size_t quad);

}  // namespace icebow
