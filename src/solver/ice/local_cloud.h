// The ice as its ranks hold it: each its own particles, nothing gathered.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/ice_cloud.h"
#include "solver/ice/sheet.h"

namespace icebow {

// Piece numbers of this rank's own particles in the order of Lattice::id, the same numbers as SheetState's;
// of a half model those of their mirror images follow in the same order. Collective: the root joins the
// ranks' pieces across their borders, for which it gets the borders only.
std::vector<std::int32_t> local_pieces(const Communicator& comm, const IceSheet& sheet);

// Collective; this rank's own particles with velocities, in the order of Lattice::id, and images likewise.
IceCloud local_cloud(const Communicator& comm, const IceSheet& sheet);

}  // namespace icebow
