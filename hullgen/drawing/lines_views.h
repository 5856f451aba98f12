// The three views of a lines plan. Each is cut from the mesh and drawn into its own place on the sheet.
#pragma once

#include "hullgen/drawing/lines_cuts.h"

namespace icebow {

void draw_profile(SvgCanvas& svg, const ForeBody& body, const View& view);
void draw_half_breadth(SvgCanvas& svg, const ForeBody& body, const View& view);
// Stations up to the shoulder to the right, the others to the left.
void draw_body_plan(SvgCanvas& svg, const ForeBody& body, const View& view);

// The lines of a second hull alone, at the first one's places, in groups of the class "second".
void overlay_profile(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view);
void overlay_half_breadth(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view);
void overlay_body_plan(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view);

}  // namespace icebow
