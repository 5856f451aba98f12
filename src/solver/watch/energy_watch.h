// The energy balance of a run, and the alarm where energy appears that nobody gave.
#pragma once

#include <vector>

#include "base/communicator.h"
#include "solver/model/history.h"
#include "solver/step/stepper.h"

namespace icebow {

class EnergyWatch {
 public:
  // Collective: the energy the sheet has now is what it starts with. The elastic energy is evaluated every
  // 1000 steps or a little less often: with the rest of the balance below 1 % of a run.
  EnergyWatch(const Communicator& comm, const Stepper& stepper, const Scenario& scenario,
              std::int64_t steps_per_sample);

  // Collective: fills in the row's energies.
  void sample(const Stepper& stepper, HistoryRow& row);
  // Energy that appeared since the balance was lowest, where it is more than rounding and the work of
  // breaking bonds explain: above a quarter of the work done so far and of the energy at the start, and above
  // that of a cube of ice, as wide as the sheet is thick, at the ship's speed. Zero otherwise [J].
  double surplus() const { return surplus_; }

  // What a run that goes on later needs; the same on every rank.
  std::vector<double> record() const {
    return {double(samples_), start_, fracture_at_start_, fracture_, lowest_};
  }
  void restore(const std::vector<double>& record) {
    samples_ = static_cast<std::int64_t>(record.at(0));
    start_ = record.at(1);
    fracture_at_start_ = record.at(2);
    fracture_ = record.at(3);
    lowest_ = record.at(4);
  }

 private:
  struct Energies {
    double kinetic, potential, elastic, fracture;
  };
  Energies joules(const std::int64_t* counts) const;  // four, in the order of EnergyCounts
  void judge(const HistoryRow& row);

  const Communicator& comm_;
  EnergyModel model_;
  int copies_;  // of the energy of a half model's port half
  std::int64_t samples_per_evaluation_, samples_ = 0;
  double start_, fracture_at_start_, fracture_ = 0.0;  //!< [J]
  double gone_ = 0.0;  // with what a moving window dropped, and to the surroundings [J]
  double lowest_ = 0.0, floor_, surplus_ = 0.0;  //!< [J]
};

}  // namespace icebow
