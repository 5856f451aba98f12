// Where the wall time of a run goes: one clock read a phase (some 25 ns), always on.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace icebow {

enum class Phase {
  drift,
  contact,
  halo_u,  // waiting for the neighbours included, as in halo_theta
  dilatation,
  halo_theta,
  force,
  surroundings,  // water, other ice, damped edges
  sampling,
  energy,
  output,  // pictures and snapshots
  checkpoint,
  other,
  count
};
constexpr int phases = static_cast<int>(Phase::count);
const char* to_string(Phase phase);

class PhaseTimer {
 public:
  // What went before belongs to no phase.
  void start() { last_ = Clock::now(); }
  // The time since the last lap (or start) belongs to this phase.
  void lap(Phase phase) {
    const Clock::time_point now = Clock::now();
    ticks_[static_cast<int>(phase)] += (now - last_).count();
    last_ = now;
  }
  double seconds(Phase phase) const {
    return std::chrono::duration<double>(Clock::duration(ticks_[static_cast<int>(phase)])).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  std::array<Clock::rep, phases> ticks_{};
};

}  // namespace icebow
