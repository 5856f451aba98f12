// Hull meshes as files: OBJ and PLY keep quads, STL is triangles (binary), VTP is ParaView's PolyData.
#pragma once

#include <string>

#include "base/quad_mesh.h"

namespace icebow {

// The format follows the ending: .obj, .stl, .ply or .vtp. Throws InputError for another ending, RuntimeError
// where the file cannot be written.
void write_mesh(const std::string& path, const QuadMesh& mesh);

// Triangles and quads of a Wavefront OBJ; groups named as patches give the patch. Throws InputError with file
// and line.
QuadMesh read_obj(const std::string& path);

}  // namespace icebow
