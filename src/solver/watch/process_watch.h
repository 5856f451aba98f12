// Follows the breaking of the ice through a run, and sums it up at the end.
#pragma once

#include "base/communicator.h"
#include "geometry/quad_mesh.h"
#include "solver/model/breaking_process.h"
#include "solver/step/stepper.h"
#include "solver/watch/crack_watch.h"
#include "solver/watch/cracks.h"
#include "solver/watch/detached_ice.h"

namespace icebow {

// Distance from the stem at the waterline aft to where the waterline first has its full breadth [m].
double entrance_length(const QuadMesh& hull);

class ProcessWatch {
 public:
  ProcessWatch(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
               const Stepper& stepper, std::int64_t steps_per_sample);

  // Collective, after a sample: new cracks, and the ice that a moving window will have dropped by the next
  // one.
  void sample(const Stepper& stepper);
  // Collective; every rank gets the same. `state` is the sheet at the end, on the root.
  BreakingProcess sum_up(const Stepper& stepper, const SheetState& state, const History& history) const;

  // Of the cracks so far; the same on every rank.
  std::vector<CrackedPlace> cracked_places(const Stepper& stepper) const;

  // As a checkpoint keeps it: columns the same on every rank, the count that of the root.
  std::vector<double> crack_record() const;
  std::vector<double> ice_record() const { return ice_.record(); }
  void restore(const std::vector<double>& cracks, const std::vector<double>& ice);

 private:
  double full_beam_x(const Stepper& stepper) const;
  CrackedSheet cracked_sheet(const Stepper& stepper) const;

  const Communicator& comm_;
  const QuadMesh& hull_;
  const Scenario& scenario_;
  std::int64_t steps_per_sample_;
  double start_x_;  //!< of the hull's frame at advance 0 [m]
  CrackWatch cracks_;
  DetachedIceCount ice_;  // dropped by a moving window
};

}  // namespace icebow
