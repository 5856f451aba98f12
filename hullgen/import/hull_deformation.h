// Free-form deformation of an imported hull's bow (Sederberg and Parry 1986), with the four angles as its
// parameters.
//
// A box holds the bow: from its aft end forward to the foremost point, from the centre plane to the largest
// half-breadth, from keel to deck. With s, t, u the place of a point in it (0 to 1) and B the Bernstein
// polynomials, a point moves by
//
//   dx = sum over i = 0..3, j = 0..2, k = 0..2 of B_i^3(s) B_j^2(t) B_k^2(u) D_ijk
//
// along the ship; y and z stay, so beam, draught and waterplane keep their measure. D_0jk = D_1jk = 0 makes
// the deformation and its slope vanish at the aft end of the box; D_2jk = D_3jk are free. Starboard is port's
// image. The slopes of profile, waterline and buttock are linear in D: of all D that give the asked angles
// and leave the stem where it is, the smallest is taken (least norm).
#pragma once

#include "hullgen/import/imported_hull.h"

namespace icebow {

// The box reaches this far aft of the stem, in lengths of the bow, at most to 0.9 of the waterline's.
constexpr double deformation_reach = 1.5;

// The hull with its bow deformed to the asked angles [rad]; an angle that is to stay is asked for as
// measured. status infeasible, with the reason, where the deformation would fold the hull (dx falls aft by
// more than the distance) or an angle is out of range; mesh_rejected where an angle is missed by more than
// 0.05 deg or the mesh intersects itself. The hull aft of the box is the same to the last bit.
Hull deformed(const ImportedHull& imported, const BowAngles& asked);

}  // namespace icebow
