// The margins g8 to g10 of a stem radius, an ice knife and a skeg; equations in docs/bows.md.
#pragma once

#include <vector>

#include "hullgen/bow/bow_surface.h"

namespace icebow {

// Those of what the bow has, in this order [m]; -1 where there is no surface to look at (null).
std::vector<Margin> centre_margins(const BowParameters& bow, const BowSurface* surface);

}  // namespace icebow
