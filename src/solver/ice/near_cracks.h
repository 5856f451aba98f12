// Ice that other ice may meet: near broken bonds.
#pragma once

#include <functional>

#include "base/communicator.h"
#include "solver/ice/sheet.h"

namespace icebow {

// visit(jl, k, il) for each of this rank's particles in a block that is within 16 particles along and across
// the course of one with a broken bond, on any rank. Collective.
void near_cracks(const Communicator& comm, const IceSheet& sheet,
                 const std::function<void(int jl, int k, int il)>& visit);

}  // namespace icebow
