// Hull meshes as files: OBJ and PLY keep quads, STL is triangles (binary), VTP is ParaView's PolyData.
#pragma once

#include <string>

#include "hullgen/mesh/polygon_mesh.h"

namespace icebow {

// The format follows the ending: .obj, .stl, .ply or .vtp. Throws InputError for another ending, RuntimeError
// where the file cannot be written.
void write_mesh(const std::string& path, const QuadMesh& mesh);

// Points and panels of a Wavefront OBJ, corners counted from the first point or (negative) back from the
// last; groups named as patches give the patch. Throws InputError with file and line.
PolygonMesh read_obj(const std::string& path);

}  // namespace icebow
