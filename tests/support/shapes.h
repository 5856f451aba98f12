// Closed quad meshes with known geometry, for tests and benchmarks.
#pragma once

#include <array>
#include <functional>
#include <set>

#include "geometry/quad_mesh.h"

namespace icebow::shapes {

using Map = std::function<Vec3(const Vec3&)>;

// The surface of the unit cube in n[0] x n[1] x n[2] steps, every point mapped. Points are not shared between
// quads, and where the map folds a face the quads have no area: as raw as a mesh can come.
QuadMesh mapped_cube(const std::array<int, 3>& n, const Map& map);

QuadMesh box(const Vec3& lower, const Vec3& upper, const std::array<int, 3>& n);

// Unit cubes at whole positions, joined: concave edges and corners.
QuadMesh cubes(const std::set<std::array<int, 3>>& cells);

// A ship-like body of about `quads` quads: sharp raked stem at the origin, flared sides, warped panels, flat
// transom. Bow length 1.4 times the beam, z from -0.6 to 0.4 times the depth.
QuadMesh hull(double length, double beam, double depth, int quads);

// Every quad as two triangles with a repeated last corner.
QuadMesh triangulated(const QuadMesh& mesh);

}  // namespace icebow::shapes
