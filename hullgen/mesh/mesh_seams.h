// Open seams: panels that meet without sharing corners.
#pragma once

#include "geometry/quad_mesh.h"

namespace icebow {

struct SeamRepairs {
  int inserted = 0;  // corners that were put into the edge of the panel beside them (T-junctions)
  int joined = 0;    // points that were joined across a gap
  double gap = 0.0;  //!< the widest gap that was closed [m]
};

// Puts every point of an open edge that lies within the distance [m] of another open edge into that edge; the
// edge's panel becomes triangles. Returns how many points were put in.
int insert_corners(QuadMesh& mesh, double distance);

// Joins points of open edges across gaps of up to `widest` [m], the nearest first, in rounds of growing
// distance; a round that leaves no fewer open edges, or makes edges of three panels, is undone. No two
// corners of one panel are joined, nor across a third of a panel's own edge.
void close_gaps(QuadMesh& mesh, double narrowest, double widest, SeamRepairs& repairs);

}  // namespace icebow
