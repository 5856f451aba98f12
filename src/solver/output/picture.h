// Top view of the broken ice as a PNG (libpng).
#pragma once

#include <string>
#include <vector>

#include "geometry/hull_section.h"
#include "geometry/quad_mesh.h"
#include "solver/ice/ice_cloud.h"

namespace icebow {

struct PictureFrame {
  double x_min, x_max, y_min, y_max;  //!< window of the sheet that is drawn [m]
  int width_px = 900;                 // the height follows
  double lambda = 1.0;                // full-scale metres of a metre here, for the scale bar
  std::string title;  // a line above the picture, with the colours explained below; empty: neither
  bool section =
      false;  // below: the ice within a spacing of the plane y = 0 and the hull in it, from the side
  std::vector<Segment> channel;  // its edges, a line each [m]
};

// Ice seen from above, bow to the right, port up: the standing sheet near-white, floes by number in
// distinguishable tints, cracks dark or in the colour of their kind, crushed ice as grey specks, open water
// blue, the deeper under water the bluer. The hull (in its own frame, its origin at (hull_x, 0), z as the
// ice's) is translucent within its waterline section, with a second line where it meets the ice's upper side.
// A scale bar gives full-scale metres. Throws RuntimeError naming the file where it cannot be written,
// std::invalid_argument for an empty window.
void write_top_view(const std::string& path, const IceCloud& ice, const QuadMesh& hull, double hull_x,
                    const PictureFrame& frame);

}  // namespace icebow
