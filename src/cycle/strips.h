// The hull's front and the ice before it, in strips along the course.
#pragma once

#include <vector>

#include "cycle/cycle_input.h"
#include "cycle/front_map.h"

namespace icebow::cycle {

struct Strips {
  std::vector<double> y, width;  //!< middle and width of each, ascending [m]
  double half_beam = 0.0;        //!< of the hull between the rows that were looked at [m]
  double length = 0.0;           //!< of the bow in ice: foremost to aftmost front [m]

  int count() const { return static_cast<int>(y.size()); }
};

// As narrow as `raster` [m] along the hull's waterline, so that a parallel side is not seen as one strip; the
// sea beside the hull, as far as `margin` [m], in strips of the raster. Mirrored about y = 0; with
// `port_only` those of y > 0. No strips where the hull has no front between the heights.
Strips make_strips(const QuadMesh& hull, double z_lower, double z_upper, double raster, double margin,
                   bool port_only);

// The hull's front as contact needs it: by strip, at heights spaced h / layers, `reach` [m] beyond the faces
// of the ice either way, since the edge goes down (or up) before it breaks.
struct HullFront {
  static constexpr int layers = 5;

  HullFront(const QuadMesh& hull, const Strips& strips, const Ice& ice, double reach);

  int bottom_row;  // of the ice at rest
  FrontMap map;
  std::vector<double> foremost;  // of each strip over all rows: FrontMap::none where there is none
};

}  // namespace icebow::cycle
