// The symmetry plane y = 0 of a half model, equation (28) of docs/theory.md: the columns -1 .. -reach are
// mirror images of the columns 0 .. reach - 1, whose bonds across the plane are then those of a neighbouring
// rank's ghosts.
#pragma once

#include "solver/ice/sheet.h"

namespace icebow {

// Of the rank at the plane; nothing to do on others. The columns 0 .. reach - 1 must be up to date with their
// ghost blocks.
void mirror_displacements(const IceSheet& sheet);
void mirror_dilatations(const IceSheet& sheet);

}  // namespace icebow
