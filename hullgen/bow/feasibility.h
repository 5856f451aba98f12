// Whether a bow of these parameters can be made: the margins g1 to g7 of docs/bows.md. Each margin is a
// closed form in the parameters, so each can say by how much a parameter has to move.
#pragma once

#include "hullgen/bow/bow.h"

namespace icebow {

// Never throws for an impossible bow: its margins say what is wrong.
BowFeasibility check_feasibility(const BowParameters& bow);

}  // namespace icebow
