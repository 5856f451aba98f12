// Hull meshes as files: OBJ and PLY keep quads, STL is triangles (binary), VTP is ParaView's PolyData.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

// The format follows the ending: .obj, .stl, .ply or .vtp, in any case. Throws InputError for another ending,
// RuntimeError where the file cannot be written.
void write_mesh(const std::string& path, const QuadMesh& mesh);

// What follows the last point of a file's name, the point too, in small letters whatever the name has.
std::string ending_of(const std::string& path);

}  // namespace icebow
