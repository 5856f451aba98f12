// Damping of the ice near the edges of the sheet: waves that run out to them do not come back. Equation (44)
// of docs/theory.md.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/energy.h"
#include "solver/scenario.h"
#include "solver/sheet.h"

namespace icebow {

// Rate of damping at the edge itself [1/s], for which a flexural wave of the sheet's characteristic length
// that crosses the damped ice twice is left with a tenth of its amplitude.
double absorbing_rate(const Scenario& scenario);

class AbsorbingEdges {
 public:
  AbsorbingEdges(const Scenario& scenario, const EnergyModel& model);
  bool acts() const { return width_ > 0.0; }

  // Adds to the accelerations of this rank's ice; returns the energy taken from it, in quanta.
  std::int64_t apply(IceSheet& sheet) const;

 private:
  double rate_at(double distance) const;  // from the nearest absorbing edge

  EnergyModel model_;
  double width_, rate_;
};

}  // namespace icebow
