// From a bow's parameters to the closed hull.
#pragma once

#include "hullgen/bow/bow.h"

namespace icebow {

// Never throws for an impossible bow: the status says so.
Hull make_hull(const BowParameters& bow);

}  // namespace icebow
