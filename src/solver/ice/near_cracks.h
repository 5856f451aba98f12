// Ice that other ice may meet: near broken bonds.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/ice/sheet.h"

namespace icebow {

// How near a crack a block of a column is, all its layers together.
enum Nearness : std::uint8_t { far_from_cracks, near_cracks, at_cracks };

// For this rank's blocks, [column][block]: at_cracks where a particle has a broken bond, near_cracks within
// 16 particles along and across the course of such a block, on any rank. Collective.
std::vector<Nearness> find_near_cracks(const Communicator& comm, const IceSheet& sheet);

}  // namespace icebow
