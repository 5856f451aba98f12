// Grid lines of the bow patch.
#pragma once

#include <vector>

#include "hullgen/bow/bow_surface.h"

namespace icebow {

// Heights of the rows, keel to deck, and etas of one side's columns, centreline to side. z = 0, the ends of
// the ice belt, eta = B/4 and the chine are among them.
struct BowGrid {
  std::vector<double> z, eta;
};

// Panels of the wanted size in the ice belt, larger away from it; by_curvature: smaller where the surface
// turns.
BowGrid bow_grid(const BowSurface& bow, double panel, bool by_curvature);

}  // namespace icebow
