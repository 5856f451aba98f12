// Meshes in PLY files, ASCII and binary of either byte order.
#pragma once

#include <string>

#include "hullgen/mesh/polygon_mesh.h"

namespace icebow {

// Points are the rows of "vertex" (x, y, z), panels those of "face" (vertex_indices or vertex_index) and the
// triangles of "tristrips" (strips end at -1). Nothing is believed that the file has no bytes for. Throws
// InputError with file, element and row.
PolygonMesh read_ply(const std::string& path);

}  // namespace icebow
