// Holes in a hull and loose pieces beside it.
#pragma once

#include <string>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// A line of open edges, each corner once.
struct OpenLoop {
  std::vector<int> ring;
  Vec3 centre = Vec3::Zero();  //!< [m]
  double across = 0.0;         //!< diagonal of its box [m]
  double off_plane = 0.0;      //!< largest distance of a corner from its mean plane [m]
  double lowest = 0.0;         //!< z of its lowest corner [m]
};
std::vector<OpenLoop> open_loops(const QuadMesh& mesh);

struct HoleRepairs {
  std::vector<std::string> words;  // what was done, with sizes and places
  bool filled = false;
};

// Leaves out open pieces that are a small part of the mesh (less than 5 % of the area of its largest
// surface): they enclose nothing. Then fills holes that have one sensible lid: flat ones (a missing deck,
// bottom or transom), small ones (2 % of the mesh's length across) and those that lie above the waterline z =
// 0.
HoleRepairs fill_holes(QuadMesh& mesh);

}  // namespace icebow
