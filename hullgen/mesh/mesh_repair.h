// Flaws of a mesh that have one remedy are mended; any other is refused with its place.
#pragma once

#include <string>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// What was done to a mesh, counted.
struct MeshRepairs {
  int split = 0;       // panels split into triangles: more than four corners, or folded along the diagonal
  int joined = 0;      // points that were another one within the tolerance
  int collapsed = 0;   // panels left with less than three points, which have no area
  int repeated = 0;    // panels that were there already
  int turned = 0;      // panels whose normal pointed inward
  int mirrored = 0;    // panels added on the other side of the centre plane
  int components = 0;  // closed surfaces the mesh consists of
};
// "2 panels that were there twice were dropped", ...; nothing where nothing was done.
std::vector<std::string> in_words(const MeshRepairs& repairs);

// Points within this of each other are one: a millionth of the mesh's longest extent [m].
double joining_distance(const QuadMesh& mesh);

// Without the points that belong to no panel, which are no part of the hull.
QuadMesh without_unused_points(const QuadMesh& mesh);

// With the image of every panel in y = 0 beside it; panels in that plane, a half hull's lid, are left out.
// Throws InputError naming the file where the mesh lies on both sides already.
QuadMesh with_mirror_image(const QuadMesh& half, const std::string& path, MeshRepairs& repairs);

// Points joined, panels without area or given twice left out, folded quads split along the other diagonal,
// all panels of each closed surface turned outward. Throws InputError naming the file and a place (hull
// frame) where an edge does not join exactly two panels, or a surface has one side only.
QuadMesh repaired(const QuadMesh& mesh, const std::string& path, MeshRepairs& repairs);

}  // namespace icebow
