// The load record of one run.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace icebow {

// One row per sample. Loads are those of the ice on the hull, averaged over the sampling interval that ends
// at `t` (impulse / interval, so the record keeps the whole impulse). The ship sails along +x: resistance is
// -F[0].
struct HistoryRow {
  double t = 0.0;                 //!< time since the start [s]
  double advance = 0.0;           //!< distance sailed since first touch [m]
  double F[3] = {0, 0, 0};        //!< force [N]
  double M[3] = {0, 0, 0};        //!< moment about the stem at the waterline [N m]
  std::int64_t broken_bonds = 0;  // so far, each bond once
  std::int64_t contacts = 0;      // particles touching the hull at the end of the interval
  double kinetic_energy = 0.0;    //!< of the ice, v(t - dt/2) . v(t + dt/2) for v^2 [J]

  // Energies since the start [J], docs/theory.md, "Energy". The ice gains hull_work - contact_loss.
  double potential = 0.0;     // weight and lift
  double hull_work = 0.0;     // of the hull on the ice
  double contact_loss = 0.0;  // of it: friction, inelastic impact, moving particles to the surface
  // That the ice has given to the water that it moves, to the ice that it meets (both may give some back),
  // and to the damped edges.
  double water_loss = 0.0, floe_loss = 0.0, edge_loss = 0.0;
  // Evaluated every few hundred steps, NaN between.
  double elastic = std::numeric_limits<double>::quiet_NaN();
  double fracture = std::numeric_limits<double>::quiet_NaN();  // of broken bonds
  // What the ice has beyond what it was given: kinetic + potential + elastic + fracture
  // + the three losses - gain.
  double balance_error = std::numeric_limits<double>::quiet_NaN();
};

struct History {
  double interval = 0.0;  //!< sampling interval [s]
  std::vector<HistoryRow> rows;
};

}  // namespace icebow
