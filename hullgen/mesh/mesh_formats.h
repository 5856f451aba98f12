// A quad mesh in the words of four file formats.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

// Coordinates as the shortest decimals that read back to the same double, except STL's 4-byte floats.
std::string obj_text(const QuadMesh& mesh);   // Wavefront OBJ; one group per patch
std::string ply_text(const QuadMesh& mesh);   // PLY, ASCII, with the patch number as face property
std::string stl_bytes(const QuadMesh& mesh);  // binary STL, triangles
std::string vtp_text(const QuadMesh& mesh);   // VTK XML PolyData, ASCII, with the patch number as cell data

const char* patch_name(Patch patch);

}  // namespace icebow
