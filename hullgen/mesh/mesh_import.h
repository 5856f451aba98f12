// Hull meshes of others: read, and brought into the frame of the hull.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"
#include "hullgen/mesh/mesh_bytes.h"
#include "hullgen/mesh/mesh_repairs.h"

namespace icebow {

// Whether the name ends like a mesh file's: .obj, .stl or .ply, in any case.
bool is_mesh_file(const std::string& path);

// The panels of an .obj, .stl (either kind) or .ply file, coordinates as they stand there. Panels of more
// than four corners are split into triangles and counted in `repairs`, with what the reader had to
// understand. Throws InputError naming the file, and the line, row or byte.
QuadMesh read_mesh(const std::string& path, MeshRepairs& repairs, const ImportProgress& progress = {});

// How a file's coordinates are meant.
struct MeshFrame {
  double unit = 1.0;                                 //!< length of a file's unit [m]
  Vec3 forward = Vec3::UnitX(), up = Vec3::UnitZ();  // perpendicular axes of the file
  bool left_handed = false;                          // the file's x, y, z are as the left hand's fingers
  double waterline = 0.0;                            //!< height of the waterline along `up` [m]
  double draft = 0.0;  //!< instead: of the waterline above the lowest point [m]; 0 = not given
};

// In metres with x forward, y to port and z up from the waterline.
QuadMesh in_hull_frame(const QuadMesh& mesh, const MeshFrame& frame);

}  // namespace icebow
