// From the surface of a bow to a closed hull of quads.
#pragma once

#include "hullgen/bow/bow.h"

namespace icebow {

// Feasible bows only, not checked. Bow patch on the grid, mirrored to starboard; side with bilge, flat bottom
// and deck run aft from its edge to a flat transom at x = -L. Reamers step back to the ship's beam first.
QuadMesh bow_mesh(const BowParameters& bow);

double panel_size(const BowParameters& bow);  //!< as asked for, or B/60 [m]

}  // namespace icebow
