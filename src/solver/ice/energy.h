// Energy of the ice sheet: kinetic, weight and lift, elastic, and what broken bonds took with them.
//
// Sums are whole multiples of a quantum in 64-bit integers, rounded block by block, so they are the
// same bit for bit on any number of ranks. Equations (20)-(22) and (27) of docs/theory.md.
#pragma once

#include <cstdint>

#include "solver/ice/sheet.h"
#include "solver/model/scenario.h"

namespace icebow {

// What the energies need besides the sheet.
struct EnergyModel {
  EnergyModel(const Scenario& scenario, const Lattice& lattice, const Material& material, double dt);

  double mass;            //!< of a particle [kg]
  double dilatation;      //!< a V: energy of a particle of unit dilatation [J]
  double s0;              // critical stretch
  double gravity;         //!< [m/s^2]; 0 = no weight and no water
  double lift;            //!< (rho_w/rho) g [m/s^2]
  double dx, inverse_dx;  //!< [m], [1/m]
  double dt;              //!< [s]
  double V;               //!< ship speed [m/s]
  double quantum;         //!< of the sums: 2^-32 m (V^2 + g h) [J]

  std::int64_t quanta(double joules) const;  // whole_multiples() of the quantum
  // Vertical acceleration by weight and lift of a particle at height z above the water, eq. (15).
  double weight_and_lift(double z) const;
  // Work against weight and lift to bring a particle from the water level to height z [J], eq. (21).
  double potential(double z) const;
};

// One rank's part, in quanta; of a half model the port half alone, with half of every bond that crosses.
struct EnergyCounts {
  std::int64_t kinetic = 0, potential = 0, elastic = 0, fracture = 0;
};

// To be asked between steps, when dilatation and acceleration belong to the displacements. Kinetic energy is
// m v(t - dt/2) . v(t + dt/2) / 2: with it a free linear sheet conserves the sum exactly, whatever its stable
// step. Potential and elastic energy are zero for the sheet where it was at the start.

// Kinetic and potential only: one pass over the particles.
EnergyCounts motion_energy(const IceSheet& sheet, const EnergyModel& model);

// All four, a pass over every bond. `fracture` counts a broken bond with its distortional energy at the
// critical stretch. What is left out: its part of the dilatation (which may have either sign), and what it
// was stretched further before its step ended.
EnergyCounts sheet_energy(const IceSheet& sheet, const EnergyModel& model);

}  // namespace icebow
