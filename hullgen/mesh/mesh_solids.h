// Surfaces as solids, through CGAL: surfaces inside surfaces, bodies that overlap.
#pragma once

#include "geometry/quad_mesh.h"
#include "hullgen/mesh/mesh_repairs.h"

namespace icebow {

// A mesh of closed surfaces with normals outward becomes one without crossings: surfaces that lie inside
// another are left out, surfaces that overlap are united. What was done is added to `repairs`. False where a
// surface crosses itself: it is left as it is.
bool make_solid(QuadMesh& mesh, MeshRepairs& repairs);

}  // namespace icebow
