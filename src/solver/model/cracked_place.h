// Where the ice has cracked, column by column.
#pragma once

#include "solver/model/breaking_process.h"

namespace icebow {

// A column of particles that belongs to a crack, where it was before it moved.
struct CrackedPlace {
  double x = 0.0, y = 0.0;  //!< x from the edge the ship came in by [m]
  CrackKind kind = CrackKind::radial;
};

}  // namespace icebow
