// ParaView files: VTK XML PolyData, data appended raw. Each array is its size in bytes (UInt64), then its
// values; the XML before it gives each array's offset from the underscore that opens the appended section.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/quad_mesh.h"
#include "solver/ice/ice_cloud.h"

namespace icebow {

// ParaView PolyData (.vtp), raw little-endian data appended; complete or absent. Throw RuntimeError naming
// the file. The particles as vertices with the point arrays displacement_m, velocity_m_per_s (3 floats),
// damage, piece (int32), and crack (int32) where the cloud has it.
void write_ice_vtp(const std::string& path, const IceCloud& ice);
// Names the ranks' files of write_ice_vtp beside it, velocities included and cracks where they have them.
void write_ice_pvtp(const std::string& path, const std::vector<std::string>& pieces, bool cracks);
// The hull's quads (triangles where a corner repeats) in its own frame, with the cell array patch (uint8, see
// Patch).
void write_hull_vtp(const std::string& path, const QuadMesh& hull);

struct PressedQuad {
  std::int32_t quad;      // of the hull
  double pressure = 0.0;  // of the ice, along the inward normal [Pa]
  Vec3 traction;          // of the ice on the hull, friction included [Pa]
};
// These quads of the hull in its own frame, with the cell arrays quad (int32), ice_pressure_Pa,
// ice_traction_Pa (3 floats).
void write_pressure_vtp(const std::string& path, const QuadMesh& hull,
                        const std::vector<PressedQuad>& pressed);
// The collection file over (time [s], file name) pairs; replaced atomically as a run goes on.
void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& steps);

}  // namespace icebow
