// A horizontal section of a hull, for drawing.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

using Vec2 = Eigen::Vector2d;
using Segment = std::pair<Vec2, Vec2>;

// Where the plane at height z cuts the closed mesh: unordered segments that together form closed loops.
// Points at z count as above it, so no segment is lost or given twice.
std::vector<Segment> hull_section(const QuadMesh& hull, double z);

}  // namespace icebow
