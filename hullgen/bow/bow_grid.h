// Grid lines of the bow patch.
#pragma once

#include <vector>

#include "hullgen/bow/bow_surface.h"

namespace icebow {

// Heights of the rows, keel to deck, and etas of one side's columns, centreline to side. z = 0, the ends of
// the ice belt, eta = B/4, the chine, the ends of what stands in the centre plane are among them.
struct BowGrid {
  std::vector<double> z, eta;
};

// Etas from the centreline outwards at which the stem's rounding, the ice knife and what else is given (0:
// none) end.
std::vector<double> centre_lines(const BowSurface& bow, std::vector<double> more);

// Panels of the wanted size in the ice belt, larger away from it; by_curvature: smaller where the surface
// turns.
// The etas `required` are among the columns.
BowGrid bow_grid(const BowSurface& bow, double panel, bool by_curvature, std::vector<double> required = {});

}  // namespace icebow
