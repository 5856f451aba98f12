// The forces of particles that touch without a bond, many pairs at a time: equation (42) of docs/theory.md.
#pragma once

#include <cstdint>

namespace icebow {

// What one particle does to another, SI.
struct FloeContactLaw {
  double distance = 0.0;   //!< below which they touch [m]
  double stiffness = 0.0;  //!< [N/m]
  double damping = 0.0;    //!< [N s/m]
  double strongest = 0.0;  //!< the ice is crushed at this force [N]
  double friction = 0.0;   // Coulomb coefficient
  double creep = 0.0;      //!< the most that friction damps pieces that hardly slide [N s/m]
};

// Pairs in lists by component x, y, z, each of whole vectors: a multiple of `floe_pairs_at_once` long.
struct FloeTouches {
  int pairs;
  const double* away[3];      //!< where the other particle lies from the one [m]
  const double* velocity[3];  //!< of the other relative to the one [m/s]
  std::int64_t* force[3];     // out, on the one, in quanta, rounded halves to even
};
constexpr int floe_pairs_at_once = 8;

}  // namespace icebow
