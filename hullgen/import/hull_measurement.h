// The angles of any hull from plane cuts of its mesh: no vertex rows, no knowledge of how it was made.
#pragma once

#include "hullgen/bow/bow.h"

namespace icebow {

struct HullMeasurement {
  BowAngles angles;
  double waterline_at_quarter_beam = 0.0;  //!< derived angle at P1 [rad]
  double flare_at_stem = 0.0;              //!< derived angle at P0 [rad]
  Vec3 P0, P1;                             //!< where they are taken [m]
  double beam = 0.0;                       //!< of the waterline; P1 is at a quarter of it [m]
};

// At the waterline z = 0 of a closed hull symmetric about y = 0, on its port side. The profile (y = 0), the
// waterline and the buttock at B/4 are cut from the panels; each slope is that of the least-squares parabola
// through the corners of the cut line within B/40, at least three and B/200 apart, one-sided for the
// waterline (the slope of the panel where a cut has two corners only), which has a crease at the stem and may
// have a jump of curvature at B/4. An angle that cannot be read is NaN. Throws InputError where the waterline
// does not cut the hull, or the bow has no profile on it.
HullMeasurement measure_hull(const QuadMesh& mesh);

}  // namespace icebow
