// A first study for somebody's own ship, from its main dimensions.
#pragma once

#include "base/json.h"
#include "hullgen/bow/bow.h"

namespace icebow {

struct FirstStudy {
  BowFamily family = BowFamily::straight_parallel_buttocks;
  double length = 147.2, beam = 23.0, draft = 8.0;  //!< of the ship [m]
  double thickness = 1.0;                           //!< of the ice [m]
  double speed = 4.0;                               //!< [kn]
  int samples = 60;                                 // bows to sweep
};

// A study document: a Latin hypercube over the angles of a bow of the family by formula and breaking cycle.
// The baseline is feasible: the family's preset at the ship's size, or the feasible bow nearest to it; so are
// the bounds, as far as feasible_box() tried them. Throws InputError where no bow of the family fits the
// ship.
Json first_study(const FirstStudy& ship);

}  // namespace icebow
