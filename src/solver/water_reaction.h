// What the water does to ice that moves across its own plane, besides its weight and lift: added mass and
// drag. Equation (41) of docs/theory.md.
//
// Column by column: a column of particles is a piece of plate whose normal joins its lowest and its highest
// particle, whichever way the floe it belongs to has turned. Water moves with the plate across its plane, and
// not along it. A column that is crushed (its particles no longer a thickness apart) is rubble and feels
// none.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/contact_energy.h"
#include "solver/scenario.h"
#include "solver/sheet.h"

namespace icebow {

class WaterReaction {
 public:
  WaterReaction(const Scenario& scenario, double dx, const EnergyModel& model);
  bool acts() const { return added_mass_ > 0.0 || drag_ > 0.0; }

  // Adds to the accelerations of this rank's ice, which must hold all other forces but weight and lift;
  // returns the energy the water takes, in quanta: its motion, which it may give back, and drag. What the
  // hull did to the velocities in this step, `strikes`, the water feels in the next.
  std::int64_t apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) const;

 private:
  template <class Real>
  std::int64_t apply_to(IceSheet& sheet, const std::vector<HullStrike>& strikes) const;

  EnergyModel model_;
  double added_mass_;  //!< of a wet face [kg]
  double drag_;        //!< of both faces, over the speed squared [kg/m]
  double dx_;          //!< [m]
};

}  // namespace icebow
