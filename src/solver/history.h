// The load record of one run.
#pragma once

#include <cstdint>
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
  double kinetic_energy = 0.0;    //!< of the ice [J]
};

struct History {
  double interval = 0.0;  //!< sampling interval [s]
  std::vector<HistoryRow> rows;
};

}  // namespace icebow
