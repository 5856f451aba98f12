// Open seams: panels that meet without sharing corners.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

struct SeamRepairs {
  int inserted = 0;            // corners that were put into the edge of the panel beside them (T-junctions)
  std::vector<Vec3> on_edges;  //!< where those were that lay on the edge within the least distance [m]
  int joined = 0;              // points that were joined across a gap
  double gap = 0.0;            //!< the widest gap that was closed [m]
};

// Puts every point of an open edge that lies within the distance [m] of another open edge into that edge; the
// edge's panel becomes triangles. A point no farther than `joinable` [m] from an end of the edge, and than a
// third of the shortest edge beside either, is left for close_gaps() to join with that end. Returns which
// points were put in, an edge's after another's.
std::vector<int> insert_corners(QuadMesh& mesh, double distance, double joinable);

// Joins points of open edges across gaps of up to `widest` [m], the nearest first, in rounds of growing
// distance, each of which puts the points left on open edges into them as insert_corners() does; a round that
// leaves no fewer open edges, or makes edges of three panels, is undone. No two corners of one panel are
// joined, nor across a third of a panel's own edge, nor two points whose joining makes an edge of three
// panels.
void close_gaps(QuadMesh& mesh, double narrowest, double widest, double joinable, SeamRepairs& repairs);

}  // namespace icebow
