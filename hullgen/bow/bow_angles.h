// The four angles of a bow, read back from its mesh.
#pragma once

#include <string>

#include "hullgen/bow/bow.h"

namespace icebow {

// The four angles from those of the second protocol: stem at P0, waterline and buttock at P1, and the
// entrance, the waterline angle at P0 [all rad]. The flare follows: tan(flare) = tan(waterline) /
// tan(buttock) at P1.
BowAngles angles_at_quarter_beam(double stem, double waterline, double buttock, double entrance);

// From vertices of the bow patch alone: profile, design waterline and the buttock at B/4 are vertex rows of
// the mesh. Each slope is that of the parabola through the three vertices nearest to P0 or P1, one-sided
// where the surface has a crease or its curvature jumps. An angle that cannot be read, because the row is
// missing, is NaN. B is the beam of the bow. With a stem rounded up to `rounded` [m] off the centre plane the
// waterline angle is that of the sides outside it, extended to the centre plane.
BowAngles measure_angles(const QuadMesh& mesh, double B, double rounded = 0.0);

// Of the bar at the stem at the design waterline [m], from how far its nose lies behind the point in which
// the sides outside `rounded` would meet: r = d / (1 / sin(waterline) - 1). NaN where the row is missing.
double measured_stem_radius(const QuadMesh& mesh, double B, double rounded);

// Largest difference of two sets [rad]; NaN counts as infinite.
double largest_difference(const BowAngles& a, const BowAngles& b);

// "" where the mesh has the angles asked for within 0.05 deg, else both sets in words.
std::string angle_mismatch(const BowAngles& asked, const BowAngles& measured);

}  // namespace icebow
