// ParaView files: VTK XML PolyData, data appended raw. Each array is its size in bytes (UInt64), then its
// values; the XML before it gives each array's offset from the underscore that opens the appended section.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/quad_mesh.h"
#include "solver/ice/ice_cloud.h"

namespace icebow {

// ParaView PolyData (.vtp), raw little-endian data appended; complete or absent. Throw RuntimeError naming
// the file. The particles as vertices with the point arrays displacement, velocity (3 floats), damage, piece
// (int32).
void write_ice_vtp(const std::string& path, const IceCloud& ice);
// Names the ranks' files of write_ice_vtp, velocities included, beside it.
void write_ice_pvtp(const std::string& path, const std::vector<std::string>& pieces);
// The hull's quads (triangles where a corner repeats) at hull_x, with the cell array patch (uint8, see
// Patch).
void write_hull_vtp(const std::string& path, const QuadMesh& hull, double hull_x);
// The collection file over (time [s], file name) pairs; replaced atomically as a run goes on.
void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& steps);

}  // namespace icebow
