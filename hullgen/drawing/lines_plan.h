// The lines plan of a hull, cut from its mesh, as one SVG drawing: profile with buttocks, half-breadth plan
// with waterlines, body plan with stations, the four angles marked at the points where they are measured.
#pragma once

#include <string>

#include "hullgen/bow/bow.h"
#include "hullgen/drawing/lines_style.h"

namespace icebow {

// A self-contained <svg> element without external references, every element with its look as plain
// attributes. For a screen CSS with currentColor and variables stands over them, so that it reads on light
// and dark pages:
// --lp-paper is the page's background, --lp-water and --lp-angle colour the design waterline and the angles,
// --lp-second a second hull.
// A hull without a mesh gives its reason instead of lines. Lengths are full scale.
std::string lines_plan_svg(const Hull& hull, const BowParameters& bow, const std::string& title,
                           DrawnFor reader = DrawnFor::screen);

struct NamedHull {
  const Hull& hull;
  const BowParameters& bow;
  std::string name;
};

// Two hulls in one plan, stems at the design waterline together: the second dashed in another colour, cut at
// the first one's half-breadths, heights and stations; a legend with both names and dimensions, and the four
// angles of both. Both need a mesh.
std::string overlaid_lines_plan_svg(const NamedHull& first, const NamedHull& second, const std::string& title,
                                    DrawnFor reader = DrawnFor::screen);

}  // namespace icebow
