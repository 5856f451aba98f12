// Wavefront OBJ.
#pragma once

#include "hullgen/mesh/mesh_bytes.h"
#include "hullgen/mesh/polygon_mesh.h"

namespace icebow {

// Points and panels. Corners count from the first point of the whole file, above or below the panel, or
// (negative) back from the last point so far. A backslash at the end of a line joins the next to it, "#"
// begins a comment anywhere. Groups named as patches give the patch. Lines, points, normals and materials are
// passed over. Throws InputError with file and line, for surfaces of curved patches (cstype, surf) too.
PolygonMesh read_obj(const std::string& path, const ImportProgress& progress = {});

}  // namespace icebow
