// One time step's passes and messages in the order that lets them overlap.
#pragma once

#include <cstdint>
#include <functional>

#include "base/communicator.h"
#include "solver/ice/halo.h"
#include "solver/ice/sheet.h"
#include "solver/model/phase_timer.h"

namespace icebow {

// Messages travel while other columns are worked on: the edges move first; the dilatation goes upwards and
// the force downwards, so that what a neighbour needs first is ready first and what it sends last is needed
// last.
class StepSchedule {
 public:
  StepSchedule(const Communicator& comm, IceSheet& sheet, PhaseTimer& timer);

  // Displaces the owned columns [jl0, jl1) for good: drift, contact.
  using Move = std::function<void(int jl0, int jl1)>;
  // Moves every column once and calls moved(), then breaks bonds and sums their accelerations. Returns how
  // many of this rank's own bonds broke. Every rank calls it at every step.
  std::int64_t run(
      const Move& move, const std::function<void()>& moved = [] {});

  // Collective: the neighbours' displacements, after something other than a step has changed them.
  void refresh();

  // Collective: dilatations once more, after bonds have gone without a step. Returns how many more broke.
  std::int64_t look_again();

  std::size_t bytes_sent() const { return displacements_.bytes_sent() + dilatations_.bytes_sent(); }

 private:
  void displace(const Move& move);
  std::int64_t dilate();
  std::int64_t accelerate();

  IceSheet& sheet_;
  PhaseTimer& timer_;
  Halo displacements_, dilatations_;
};

}  // namespace icebow
