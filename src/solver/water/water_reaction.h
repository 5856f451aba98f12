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
  bool acts() const { return added_mass_ > 0.0 || drag_ > 0.0 || plane_; }

  // Collective. Adds to the accelerations of this rank's ice, which must hold all other forces but weight and
  // lift; returns the energy the water takes, in quanta: its motion, which it may give back, and drag. What
  // the hull did to the velocities in this step, `strikes`, the water feels in the next.
  std::int64_t apply(IceSheet& sheet, const std::vector<HullStrike>& strikes);

 private:
  // A column in the water, along its normal.
  struct Column {
    std::ptrdiff_t p;  // its lowest particle in the fields
    int block, cell;   // of this rank's blocks; of the water's plane
    Vec3 n;
    double mass = 0.0;   //!< with its own added mass [kg]; 0 where the water does nothing
    double share = 0.0;  // that lies in the plane
    double v, a;         //!< mean velocity [m/s]; acceleration of all forces but the water's [m/s^2]
    double reached;      //!< acceleration with the strike, own added mass and drag [m/s^2]
    double change;       //!< what the water has added to it [m/s^2]
  };
  struct Wet {  // shares of the lower and the higher face
    double low, high;
  };

  template <class Real>
  std::int64_t apply_to(IceSheet& sheet, const std::vector<HullStrike>& strikes);
  template <class Real>
  void find_columns(const IceSheet& sheet, const std::vector<HullStrike>& strikes);
  template <class Real>
  bool plate(const IceSheet& sheet, Column& column, Wet& wet) const;
  template <class Real>
  void react(const IceSheet& sheet, Column& column, const Vec3& struck) const;
  void resist_plane();
  template <class Real>
  std::int64_t push(IceSheet& sheet) const;

  Communicator comm_;
  EnergyModel model_;
  double added_mass_;  //!< of a wet face [kg]
  double drag_;        //!< of both faces, over the speed squared [kg/m]
  double thickness_;   //!< [m]
  int cell_ = 1;       // columns along the side of a cell of the plane
  int cells_across_ = 0;
  double most_mobile_ = 0.0;  //!< a cell of whole ice, all of it in the plane [1/kg]
  std::unique_ptr<WaterPlane> plane_;
  std::vector<Column> columns_;  // of this rank, in the step under way
};

}  // namespace icebow
