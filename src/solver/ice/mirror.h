// The symmetry plane y = 0 of a half model, equation (28) of docs/theory.md: the columns -1 .. -reach are
// mirror images of the columns 0 .. reach - 1, whose bonds across the plane are then those of a neighbouring
// rank's ghosts.
#pragma once

#include "solver/ice/sheet.h"

namespace icebow {

// Only the rank at the plane has something to do. Its columns 0 .. reach - 1 must be up to date with their
// ghost blocks.
void mirror_displacements(IceSheet& sheet);
void mirror_dilatations(IceSheet& sheet);
// A bond across the plane from the image of an own particle to a particle of a neighbour along the course is
// nobody's to work on here. It is alive where its own mirror image is, which ends in an own particle.
void mirror_bonds_beyond_ends(IceSheet& sheet);

}  // namespace icebow
