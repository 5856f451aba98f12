// The skeg of a bow: a fin of triangular section under the flat bottom; equation (13) of docs/bows.md.
#pragma once

#include <vector>

#include "hullgen/bow/bow.h"

namespace icebow {

struct Skeg {
  double height = 0.0, angle = 0.0;             //!< [m], [rad]
  double half_width = 0.0, share_of_eta = 1.0;  //!< eta of its root [m], and y over eta there
  double length = 0.0;                          //!< [m]
  double bottom =
      0.0;  //!< length of the bottom along the centreline, from whose fore end the skeg runs aft [m]

  // How far the skeg reaches below the bottom [m], at this share of the bottom's length and this eta.
  double depth(double share, double eta) const;
  std::vector<double> shares() const;  // where its ends begin and end, fore to aft; empty without a skeg
  double volume() const;               //!< [m^3]
};

Skeg skeg_of(const BowParameters& bow);

}  // namespace icebow
