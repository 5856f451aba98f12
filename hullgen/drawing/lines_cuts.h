// What the views of a lines plan show: the hulls, the lines cut from them, and how numbers are written.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_slice.h"
#include "hullgen/bow/bow.h"
#include "hullgen/drawing/svg_canvas.h"

namespace icebow {

// Room the views need [m]: s from tip to window, heights from low to high, half-breadths up to half.
struct Extent {
  double tip, window, low, high, half;
};

struct ForeBody {
  const Hull& hull;
  const BowParameters& bow;
  double tip, end;  //!< s of the foremost point and of the aft end of the bow patch [m]
  double s1;        //!< s of P1, the point of the design waterline at B/4 [m]
  double waterline_step, station_step, aft_station_step;  //!< [m]
  Extent extent;
};
ForeBody fore_body(const Hull& hull, const BowParameters& bow);
// Both get the room that either needs.
void share_extent(ForeBody& a, ForeBody& b);

// Where hull coordinates (0, 0) stand on the sheet, and pixels per metre.
struct View {
  Pixel origin;
  double scale;
  Pixel at(double across, double up) const { return {origin.x + scale * across, origin.y - scale * up}; }
};

// A line of a view: the plane it is cut with, its style class and its name.
struct LineOfView {
  double at;
  std::string style_class, name;
};
// At the half-breadths, heights and distances aft of `spacing`, so that lines of two hulls can be compared;
// the outlines, flat of side and flat of bottom are `own`.
std::vector<LineOfView> buttocks(const ForeBody& own, const ForeBody& spacing);
std::vector<LineOfView> waterlines(const ForeBody& own, const ForeBody& spacing);
std::vector<LineOfView> fore_stations(const ForeBody& spacing);  // up to the shoulder
std::vector<LineOfView> aft_stations(const ForeBody& spacing);   // aft of it
std::vector<double> waterline_heights(const ForeBody& b);

// What a view leaves out: the part of a line with point[axis] < lower.
struct ViewLimit {
  int axis;
  double lower;
};
// Draws a plane's cut in a view that shows the axes `across` (times sign) and `up`.
void draw_cut(SvgCanvas& svg, const View& view, const std::vector<Polyline>& cut, int across, int up,
              double sign, const std::vector<ViewLimit>& limits, const std::string& style_class);

// The point of a cut that is extreme in `first`; among equals, in `second` (each +1/-1 times an axis). NaN
// where the cut is empty.
struct Extreme {
  int axis;
  double sign;
};
Vec3 extreme_point(const std::vector<Polyline>& cut, Extreme first, Extreme second);

std::vector<double> multiples(double step, double from, double to);
// "-2", "+3", "0"; a true minus sign reads better in a drawing.
std::string signed_metres(double value);
std::string metres(double value);

}  // namespace icebow
