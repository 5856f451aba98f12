// What the water does to ice that moves across its own plane, besides its weight and lift: added mass and
// drag. Equations (41) and (44) of docs/theory.md.
//
// Column by column: a column of particles is a piece of plate whose normal joins its lowest and its highest
// particle, whichever way the floe it belongs to has turned. Water moves with the plate across its plane, and
// not along it. A column that is crushed (its particles no longer a thickness apart) is rubble and feels
// none. Ice that still lies in the sheet's plane can be given the inertia of all the water under the plane
// instead of a layer's.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/communicator.h"
#include "solver/contact/contact_energy.h"
#include "solver/ice/sheet.h"
#include "solver/model/scenario.h"
#include "solver/water/water_plane.h"

namespace icebow {

class WaterReaction {
 public:
  WaterReaction(const Communicator& comm, const Scenario& scenario, const Lattice& lattice,
                const EnergyModel& model);
  bool acts() const { return law_.added_mass > 0.0 || law_.drag > 0.0 || plane_; }

  // Collective. Adds to the accelerations of this rank's ice, which must hold all other forces but weight and
  // lift; returns the energy the water takes, in quanta: its motion, which it may give back, and drag. What
  // the hull did to the velocities in this step, `strikes`, the water feels in the next.
  std::int64_t apply(IceSheet& sheet, const std::vector<HullStrike>& strikes);

 private:
  using Struck =
      std::vector<std::pair<std::ptrdiff_t, Vec3>>;  // columns by place, and what the hull did to them
  template <class Real>
  std::int64_t apply_to(IceSheet& sheet, const Struck& struck);
  template <class Real>
  WaterFields<Real> fields(IceSheet& sheet, int jl, int b) const;
  const WaterStrikes* strikes_at(const Layout& layout, int jl, int b, const Struck& struck);
  unsigned mobile(const IceSheet& sheet, int jl, int b);
  void resist_plane(const Layout& layout);

  Communicator comm_;
  EnergyModel model_;
  WaterLaw law_;
  int cell_ = 1;  // columns along the side of a cell of the plane
  int cells_across_ = 0;
  double most_mobile_ = 0.0;  //!< a cell of whole ice, all of it in the plane [1/kg]
  std::unique_ptr<WaterPlane> plane_;
  std::vector<std::uint16_t>
      mobile_;  // [column][block]: a bit a column of particles; the lattice's, so for good
  std::vector<WaterColumns> blocks_;  // [column][block] of this rank, in the step under way
  WaterStrikes strikes_;              // of the block at hand
};

}  // namespace icebow
