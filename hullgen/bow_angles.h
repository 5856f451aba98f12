// The four angles of a bow, read back from its mesh.
#pragma once

#include <string>

#include "hullgen/bow.h"

namespace icebow {

// From vertices of the bow patch alone: profile, design waterline and the buttock at B/4 are vertex rows of
// the mesh. Each slope is that of the parabola through the three vertices nearest to P0 or P1, one-sided
// where the surface has a crease or its curvature jumps. An angle that cannot be read, because the row is
// missing, is NaN. B is the beam of the bow.
BowAngles measure_angles(const QuadMesh& mesh, double B);

// Largest difference of two sets [rad]; NaN counts as infinite.
double largest_difference(const BowAngles& a, const BowAngles& b);

// "" where the mesh has the angles asked for within 0.05 deg, else both sets in words.
std::string angle_mismatch(const BowAngles& asked, const BowAngles& measured);

}  // namespace icebow
