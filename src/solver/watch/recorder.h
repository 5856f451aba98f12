// The load record: samples the stepper at a fixed interval, the same on any number of ranks.
#pragma once

#include <string>

#include "base/communicator.h"
#include "solver/model/history.h"
#include "solver/step/stepper.h"
#include "solver/watch/energy_watch.h"

namespace icebow {

class Recorder {
 public:
  // `dt_limit` [s] is for the words of a failure; 0 = unknown.
  Recorder(const Communicator& comm, const Stepper& stepper, const Scenario& scenario, double dt_limit = 0.0);

  std::int64_t steps_per_sample() const { return steps_per_sample_; }
  // Collective: adds a row for the interval that ends now. False where the ice is no longer finite, is faster
  // than a sound wave, or has energy that nobody gave it (EnergyWatch); `reason` then says when and where,
  // and what the likely cause is.
  bool sample(Stepper& stepper, std::string& reason);
  const History& history() const { return history_; }
  const EnergyWatch& energy_watch() const { return watch_; }
  void restore(const std::vector<HistoryRow>& rows, const std::vector<double>& watch) {
    history_.rows = rows;
    watch_.restore(watch);
  }

 private:
  struct Motion {
    double fastest = 0.0;   //!< [m/s]
    std::size_t where = 0;  // the fastest particle
  };
  static Motion motion(const IceSheet& sheet);
  std::string describe_failure(const Stepper& stepper, const Motion& motion, double fastest) const;

  const Communicator& comm_;
  double V_, fastest_allowed_, dt_limit_;
  std::int64_t steps_per_sample_;
  EnergyWatch watch_;
  History history_;
};

}  // namespace icebow
