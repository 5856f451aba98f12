// What was done to a mesh before it became a hull.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace icebow {

struct MeshRepairs {
  int split = 0;      // panels split into triangles: more than four corners, or folded along the diagonal
  int joined = 0;     // points that were another one within the tolerance
  int collapsed = 0;  // panels left with less than three points, which have no area
  int repeated = 0;   // panels that were there already
  int turned = 0;     // panels whose normal pointed inward
  int mirrored = 0;   // panels added on the other side of the centre plane
  int walls = 0;      // panels that stood between two bodies, on both
  int inserted = 0;   // points put into the edge of the panel beside them
  std::vector<Vec3> on_edges;         //!< where those were that lay on the edge [m]
  int gaps = 0;                       // points joined across gaps
  double gap = 0.0;                   //!< the widest of those [m]
  int moved_to_centre = 0;            // points of a half hull's rim that were moved onto the centre plane
  double off_centre = 0.0;            //!< the farthest of those [m]
  int components = 0;                 // closed surfaces the mesh consists of
  std::vector<std::string> notes;     // other things that were done, in words with sizes and places
  std::vector<std::string> warnings;  // what may be wrong with the hull as it stands
};
// "2 panels that were there twice were dropped", ...; nothing where nothing was done.
std::vector<std::string> in_words(const MeshRepairs& repairs);

}  // namespace icebow
