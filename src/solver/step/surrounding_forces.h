// Forces on the ice besides its bonds, its weight and the hull: of the water it moves, of other ice, and of
// the damped edges. Each is off unless the scenario asks for it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/communicator.h"
#include "solver/contact/floe_contact.h"
#include "solver/water/absorbing_edges.h"
#include "solver/water/water_reaction.h"

namespace icebow {

// Energy that the ice has given away, of one rank, in quanta of the energy model.
struct SurroundingsCounts {
  std::int64_t water = 0, floes = 0, edges = 0;
};

class SurroundingForces {
 public:
  SurroundingForces(const Communicator& comm, const Scenario& scenario, const Lattice& lattice,
                    const Material& material, const EnergyModel& model);
  bool act() const { return water_.acts() || floes_.acts() || edges_.acts(); }

  // Collective. The ice has moved for good in the last of so many steps: what other ranks need of it travels
  // from now on.
  void moved(const IceSheet& sheet, std::int64_t steps) {
    if (!may_pause(steps)) floes_.send(sheet);
  }
  // Collective. Adds to the accelerations of the bonds after so many steps, in the last of which the hull
  // struck the ice. Returns the work of its relocations against other ice, in quanta.
  std::int64_t apply(IceSheet& sheet, std::int64_t steps, const std::vector<HullStrike>& strikes);
  // Collective. Where the ice has been renumbered, or a run goes on that has been interrupted.
  void renumbered(const IceSheet& sheet) {
    floes_.renumbered();
    floes_.find_pairs(sheet);
  }

  // Whether pairs of ice were looked for in the last of so many steps, as where a run goes on.
  bool may_pause(std::int64_t steps) const {
    return !floes_.acts() || steps % steps_per_sample_ % pairs_every == 0;
  }

  const SurroundingsCounts& counts() const { return counts_; }
  void restore(const SurroundingsCounts& counts) { counts_ = counts; }

 private:
  WaterReaction water_;
  FloeContact floes_;
  AbsorbingEdges edges_;
  std::int64_t steps_per_sample_;
  SurroundingsCounts counts_;
};

}  // namespace icebow
