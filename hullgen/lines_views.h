// The three views of a lines plan. Each is cut from the mesh and drawn into its own place on the sheet.
#pragma once

#include "hullgen/bow.h"
#include "hullgen/svg_canvas.h"

namespace icebow {

// What the views share.
struct ForeBody {
  const Hull& hull;
  const BowParameters& bow;
  double tip, end;  //!< s of the foremost point and of the aft end of the bow patch [m]
  double s1;        //!< s of P1, the point of the design waterline at B/4 [m]
  double window;    //!< the drawing reaches this far aft [m]
  double waterline_step, station_step, aft_station_step;  //!< [m]
};
ForeBody fore_body(const Hull& hull, const BowParameters& bow);

// Where hull coordinates (0, 0) stand on the sheet, and pixels per metre.
struct View {
  Pixel origin;
  double scale;
  Pixel at(double across, double up) const { return {origin.x + scale * across, origin.y - scale * up}; }
};

void draw_profile(SvgCanvas& svg, const ForeBody& body, const View& view);
void draw_half_breadth(SvgCanvas& svg, const ForeBody& body, const View& view);
void draw_body_plan(SvgCanvas& svg, const ForeBody& body, const View& view);

}  // namespace icebow
