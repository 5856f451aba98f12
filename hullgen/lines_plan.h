// The lines plan of a hull, cut from its mesh, as one SVG drawing: profile with buttocks, half-breadth plan
// with waterlines, body plan with stations, the four angles marked at the points where they are measured.
#pragma once

#include <string>

#include "hullgen/bow.h"

namespace icebow {

// A self-contained <svg> element (no external references, colours by CSS currentColor and variables so that
// it reads on light and dark pages: --lp-paper is the page's background, --lp-water and --lp-angle colour the
// design waterline and the angles). A hull without a mesh gives its reason instead of lines. Lengths are full
// scale.
std::string lines_plan_svg(const Hull& hull, const BowParameters& bow, const std::string& title);

}  // namespace icebow
