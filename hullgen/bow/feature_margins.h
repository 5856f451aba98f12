// The margin g7 of bows with reamers or chines; equations in docs/bows.md.
#pragma once

#include "hullgen/bow/bow_surface.h"

namespace icebow {

Margin reamer_size(const BowParameters& bow);  //!< [m]
Margin chine_crease(const BowSurface& bow);    //!< [rad]

}  // namespace icebow
