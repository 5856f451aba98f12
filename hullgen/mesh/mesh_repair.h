// Flaws of a mesh that have one remedy are mended; any other is refused with its place.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"
#include "hullgen/mesh/mesh_repairs.h"

namespace icebow {

// Points within this of each other are one: a millionth of the mesh's longest extent [m].
double joining_distance(const QuadMesh& mesh);

// With the image of every panel in y = 0 beside it; panels in that plane, a half hull's lid, are left out.
// Points of the rim that lie off the plane by up to a thousandth of the breadth are moved onto it. Throws
// InputError naming the file where the mesh lies on both sides already.
QuadMesh with_mirror_image(const QuadMesh& half, const std::string& path, MeshRepairs& repairs);

// Mends what has one remedy, and counts it: points joined, panels without area or given twice left out, quads
// that fold or share a diagonal split along the other one, points put into the edges they lie on, gaps of up
// to a thousandth of the length closed, walls inside removed, loose pieces left out, holes with one sensible
// lid filled (mesh_holes.h); then all panels of each closed surface turned outward. Throws InputError naming
// the file and a place (hull frame) where an edge still does not join exactly two panels, or a surface has
// one side only.
QuadMesh repaired(const QuadMesh& mesh, const std::string& path, MeshRepairs& repairs);

}  // namespace icebow
