// Damping of the ice near the edges of the sheet: waves that run out to them do not come back. Equation (43)
// of docs/theory.md.
#pragma once

#include <cstdint>

#include "solver/ice/energy.h"
#include "solver/ice/sheet.h"
#include "solver/model/scenario.h"

namespace icebow {

class AbsorbingEdges {
 public:
  AbsorbingEdges(const Scenario& scenario, const EnergyModel& model);
  bool acts() const { return width_ > 0.0; }

  // Adds to the accelerations of this rank's ice; returns the energy taken from it, in quanta.
  std::int64_t apply(IceSheet& sheet) const;

 private:
  double rate_at(double distance) const;  // from the nearest absorbing edge
  // Damps particle p at height z; returns the energy taken [J].
  double damp(IceSheet& sheet, std::size_t p, double z, double rate) const;

  EnergyModel model_;
  double width_;  //!< [m]
  double rate_;   //!< at the edge itself [1/s]
};

}  // namespace icebow
