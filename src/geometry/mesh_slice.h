// Plane cuts of a mesh as polylines: buttocks, waterlines and sections.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

using Polyline = std::vector<Vec3>;

// Where the plane {point[axis] = at} (axis 0 x, 1 y, 2 z) cuts a closed oriented mesh: closed loops, first
// point repeated at the end. A vertex in the plane counts as above it, so a plane through a row of vertices
// gives that row.
std::vector<Polyline> slice(const QuadMesh& mesh, int axis, double at);

// The parts of a line on the side point[axis] >= lower.
std::vector<Polyline> clipped(const Polyline& line, int axis, double lower);

}  // namespace icebow
