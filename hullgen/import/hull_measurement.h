// The angles of any hull from plane cuts of its mesh: no vertex rows, no knowledge of how it was made.
#pragma once

#include <vector>

#include "hullgen/bow/bow.h"

namespace icebow {

struct HullMeasurement {
  BowAngles angles;
  double waterline_at_quarter_beam = 0.0;  //!< derived angle at P1 [rad]
  double flare_at_stem = 0.0;              //!< derived angle at P0 [rad]
  Vec3 P0, P1;                             //!< where they are taken [m]
  double beam = 0.0;                       //!< of the waterline; P1 is at a quarter of it [m]
  double stem_radius = 0.0;                //!< of a bar at the stem; 0: the sides meet in an edge [m]
  BowAngles spread;  //!< how far the angles may be off, by reading them in other ways [rad]
  double spread_at_quarter_beam = 0.0;  //!< of waterline_at_quarter_beam [rad]
  BowAngles starboard;                  //!< the other side's, from measure_both_sides() alone [rad]
};

// At the waterline z = 0 of a closed hull about y = 0, on its port side; of several loops of the waterline
// the one that encloses most is the ship's. Where the mesh has points along the profile (y = 0), the
// waterline and the buttock at B/4, as a hull with rows of points has, each slope is that of the
// least-squares parabola through the points of the cut within B/40, at least three and B/200 apart, up to the
// first knuckle; one-sided for the waterline, which has a crease at the stem and may have a jump of curvature
// at B/4. Otherwise entrance, buttock and flare come from the normal of the surface fitted to the mesh's
// points (surface_normal.h), for a cut through panels lies off the surface. With a bar at the stem the
// entrance is that of the sides outside it, extended to the centre plane. Vertical is a flare of 0. An angle
// that cannot be read is NaN. Points `on_chords` (chord_points.h) are not asked. Throws InputError where the
// waterline does not cut the hull, or the bow has no profile on it.
HullMeasurement measure_hull(const QuadMesh& mesh, const std::vector<int>& on_chords = {});

// With starboard's angles too, and a spread that covers half of what the sides differ by.
HullMeasurement measure_both_sides(const QuadMesh& mesh, const std::vector<int>& on_chords = {});

}  // namespace icebow
