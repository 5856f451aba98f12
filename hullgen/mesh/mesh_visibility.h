// What of a mesh is seen from outside, by rays (CGAL): walls inside a hull and the inside of an open boat are
// not.
#pragma once

#include "geometry/quad_mesh.h"
#include "hullgen/mesh/mesh_repairs.h"

namespace icebow {

// Where edges join three panels or more: leaves out the pieces between such edges that the outside cannot be
// seen from (decks, bulkheads, tank walls) or that are seen on both sides (sheets like a bilge keel), and
// gives bodies that touch along an edge edges of their own. Nothing is changed where this leaves no fewer
// such edges.
void remove_inner_panels(QuadMesh& mesh, MeshRepairs& repairs);

// The panels that are seen from beside or below: the outside of an open boat drawn with its plating, without
// the inside and the rim.
QuadMesh outer_surface(const QuadMesh& mesh);

}  // namespace icebow
