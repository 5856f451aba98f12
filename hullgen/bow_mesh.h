// From the surface of a bow to a closed hull of quads.
#pragma once

#include "hullgen/bow_surface.h"

namespace icebow {

// Heights of the grid lines of the bow, keel to deck, and etas, centreline to side. z = 0, the ends of the
// ice belt and eta = B/4 are among them.
struct BowGrid {
  std::vector<double> z, eta;
};
BowGrid bow_grid(const BowSurface& bow, double panel);

// Feasible bows only, not checked. Bow patch on the grid, mirrored to starboard; side with bilge, flat bottom
// and deck run aft from its edge to a flat transom at x = -L.
QuadMesh bow_mesh(const BowParameters& bow);

double panel_size(const BowParameters& bow);  //!< as asked for, or B/60 [m]

}  // namespace icebow
