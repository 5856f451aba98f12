// Wall time of a run by phase, over all ranks.
#pragma once

#include <string>
#include <vector>

#include "base/communicator.h"
#include "solver/model/phase_timer.h"

namespace icebow {

struct PhaseTime {
  std::string phase;
  double mean = 0.0, max = 0.0;  //!< over the ranks [s]
};
using Profile = std::vector<PhaseTime>;  // in the order of Phase; phases that took no time are left out

// Collective; every rank returns the same.
Profile profile_of(const Communicator& comm, const PhaseTimer& timer);

}  // namespace icebow
