// The waterline of a hull: which of its loops is the ship, its ends, and how sharp the stem is.
#pragma once

#include "geometry/mesh_slice.h"

namespace icebow {

// The loop at height z that encloses most, and what else is cut there.
struct Waterline {
  Polyline loop;      // closed, counter-clockwise seen from above; empty where z cuts nothing
  double area = 0.0;  //!< inside the loop [m^2]
  double hole_area =
      0.0;  //!< of loops inside it that bound no hull: open wells, or an open boat's inside [m^2]
  Vec3 hole = Vec3::Zero();            //!< a point of the largest of those [m]
  int islands = 0;                     // loops beside it
  double port = 0.0, starboard = 0.0;  //!< largest and smallest y [m]
};
Waterline waterline_at(const QuadMesh& mesh, double z);

// From the stem on the centre plane aft along port, as far as y grows; the first point has y = 0.
Polyline port_side_from_stem(const Waterline& waterline);

// A bar of radius r at the stem, where the sides outside it, extended, would meet in a point ahead of it.
struct StemBar {
  double radius = 0.0;      //!< [m], 0: sharp
  double half_width = 0.0;  //!< where the sides begin [m]
};
// `side` from port_side_from_stem().
StemBar stem_bar(const Polyline& side, double beam);

}  // namespace icebow
