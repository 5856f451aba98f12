// Which way the panels of a mesh face.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

// Turns panels over so that each closed surface of the mesh has its normals outward; adds their number to
// `turned` and returns how many closed surfaces there are. Throws InputError naming the file where an edge
// does not join exactly two panels (how many such edges, and where one is), or a surface has one side only.
// Surfaces that enclose nothing are left out; where there is no other, that is an error too.
int turn_outward(QuadMesh& mesh, const std::string& path, int& turned);

}  // namespace icebow
