// STL of either kind.
#pragma once

#include "hullgen/mesh/mesh_bytes.h"
#include "hullgen/mesh/polygon_mesh.h"

namespace icebow {

// Triangles; points that are the same to the last bit become one, as STL repeats them. Text may have words in
// any case, commas between numbers, several solids, and may lack "endsolid". A binary file's count must fit
// its size; a count of zero, which programs leave that write without going back, is taken from the size and
// noted. Throws InputError with the line of a text, the byte of a binary file.
PolygonMesh read_stl(const std::string& path, const ImportProgress& progress = {});

}  // namespace icebow
