// Hull meshes of others: read, and brought into the frame of the hull.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

// The panels of an .obj, .stl (either kind) or .ply file, coordinates as they stand there. Points that are
// the same to the last bit become one, as STL repeats them. Panels of more than four corners are split into
// triangles; their number is added to `split`. Throws InputError naming the file, in an OBJ the line too.
QuadMesh read_mesh(const std::string& path, int& split);

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

// y counted from the middle of the mesh where that is off y = 0 by more than 1e-6 of the width, as the centre
// plane is asked for.
QuadMesh centred(const QuadMesh& mesh);

}  // namespace icebow
