// The load record: samples the stepper at a fixed interval, the same on any number of ranks.
#pragma once

#include <string>

#include "base/communicator.h"
#include "solver/history.h"
#include "solver/stepper.h"

namespace icebow {

class Recorder {
 public:
  Recorder(const Communicator& comm, const Stepper& stepper, const Scenario& scenario);

  std::int64_t steps_per_sample() const { return steps_per_sample_; }
  // Collective: adds a row for the interval that ends now. False where the ice is no longer finite, or faster
  // than a sound wave; `reason` then says where and when.
  bool sample(Stepper& stepper, std::string& reason);
  const History& history() const { return history_; }
  void restore(const std::vector<HistoryRow>& rows) { history_.rows = rows; }

 private:
  const Communicator& comm_;
  double particle_mass_, V_, fastest_allowed_, energy_quantum_;
  std::int64_t steps_per_sample_;
  History history_;
};

// Seconds between samples: 1/12.5 of sqrt(h/g), the time scale of a floating sheet; 5 ms for a 40 mm sheet.
double sampling_interval(double h);

}  // namespace icebow
