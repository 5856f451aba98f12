// Hull meshes of others: read, brought into the frame of the hull, and refused with a reason where they do
// not bound a volume.
#pragma once

#include <string>

#include "base/quad_mesh.h"

namespace icebow {

// Triangles and quads of an .obj, .stl (either kind) or .ply file, coordinates as they stand there. Points
// that are the same to the last bit become one, as STL repeats them. Throws InputError.
QuadMesh read_mesh(const std::string& path);

// How a file's coordinates are meant.
struct MeshFrame {
  double unit = 1.0;                                 //!< length of a file's unit [m]
  Vec3 forward = Vec3::UnitX(), up = Vec3::UnitZ();  // perpendicular axes of the file
  double waterline = 0.0;                            //!< height of the waterline along `up` [m]
};

// In metres with x forward, y to port and z up from the waterline. y is counted from the middle of the
// mesh where that is off the file's y = 0 by more than 1e-6 of the width, as the centre plane is asked for.
QuadMesh in_hull_frame(const QuadMesh& mesh, const MeshFrame& frame);

// The mesh with outward normals: one whose panels all face inward is turned over. Throws InputError naming
// the file where it is not closed (how many open edges, and where one is), not an oriented manifold, or
// intersects itself.
QuadMesh outward(const QuadMesh& mesh, const std::string& path);

}  // namespace icebow
