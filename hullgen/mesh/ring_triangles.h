// A ring of corners as triangles, through CGAL.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"

namespace icebow {

// Triangles of the ring in its own order, of the points of `points` that it names; none where the ring
// crosses itself or has no area. A flat ring gets a Delaunay triangulation of its plane, any other the one
// that turns least from triangle to triangle; corners on a straight line make no triangle of their own.
std::vector<std::array<int, 3>> ring_triangles(const std::vector<Vec3>& points, const std::vector<int>& ring);

}  // namespace icebow
