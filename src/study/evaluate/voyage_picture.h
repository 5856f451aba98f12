// A voyage of the cycle as a drawing: channel and cusps as seen from above, and the load on the way.
#pragma once

#include <string>

#include "cycle/voyage.h"
#include "hullgen/drawing/svg_style.h"

namespace icebow {

// The last `way` [m] of the voyage as an SVG; the pieces want their shapes. `submersion` [N] is added to the
// load.
std::string voyage_svg(const cycle::VoyageResult& voyage, const std::vector<Vec3>& waterline,
                       double submersion, double way, const std::string& title);

const SvgStyle& voyage_style();

}  // namespace icebow
