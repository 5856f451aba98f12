// The volume that a bow's hull displaces, from the equations of its surface: no mesh, microseconds.
#pragma once

#include <optional>

#include "hullgen/bow/bow.h"

namespace icebow {

// Under the design waterline, skeg included, of the smooth hull [m^3]; equation (10) of docs/bows.md. A mesh
// with panels of B/60 has it within 0.1 %. Dimensions and angles must be in range: g6 of check_feasibility()
// is 0 or more.
double bow_displacement(const BowParameters& bow);

enum class HeldBy { length, beam, draft };

// The length, beam or draught [m] with which the bow displaces the volume [m^3], its other parameters as they
// are: the length in closed form, for the volume is linear in it, the others by bisection between `lower` and
// `upper`. Nothing where no value there does, or dimensions or angles are out of range.
std::optional<double> dimension_for_displacement(const BowParameters& bow, double volume, HeldBy by,
                                                 double lower, double upper);

// A displacement that a bow keeps, by one dimension between two bounds [m].
struct HeldDisplacement {
  double volume = 0.0;  //!< [m^3]
  HeldBy by = HeldBy::length;
  double lower = 0.0, upper = 0.0;  //!< [m]
};

}  // namespace icebow
