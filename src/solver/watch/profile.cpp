#include "solver/watch/profile.h"

#include "base/collective.h"

namespace icebow {

Profile profile_of(const Communicator& comm, const PhaseTimer& timer) {
  double sums[phases];
  for (int p = 0; p < phases; ++p) sums[p] = timer.seconds(static_cast<Phase>(p));
  comm.sum(sums, phases);
  broadcast(comm, sums);
  Profile profile;
  for (int p = 0; p < phases; ++p) {
    const Phase phase = static_cast<Phase>(p);
    const double max = comm.max(timer.seconds(phase));
    if (max > 0.0) profile.push_back({to_string(phase), sums[p] / comm.size(), max});
  }
  return profile;
}

}  // namespace icebow
