#include "solver/step/surrounding_forces.h"

#include "solver/model/record_interval.h"

namespace icebow {

SurroundingForces::SurroundingForces(const Communicator& comm, const Scenario& s, const Lattice& lattice,
                                     const Material& material, const EnergyModel& model)
    : water_(comm, s, lattice, model),
      floes_(comm, s, material, model),
      edges_(s, model),
      steps_per_sample_(sampling_steps(s.ice.h, model.dt)) {}

std::int64_t SurroundingForces::apply(IceSheet& sheet, std::int64_t steps,
                                      const std::vector<HullStrike>& strikes) {
  FloeWork floes;
  if (floes_.acts()) {
    if (may_pause(steps)) floes_.find_pairs(sheet);  // a run that goes on does so where it goes on
    floes = floes_.apply(sheet, strikes);
    counts_.floes += floes.taken;
  }
  if (edges_.acts()) counts_.edges += edges_.apply(sheet);
  // The last: water goes with whatever accelerates the ice.
  if (water_.acts()) counts_.water += water_.apply(sheet, strikes);
  return floes.by_hull;
}

}  // namespace icebow
