// What the broken ice costs on its way under or round the hull, by energy over the hull's own surface.
// docs/cycle.md, (C12) to (C15).
#pragma once

#include "cycle/cycle_input.h"
#include "geometry/quad_mesh.h"

namespace icebow::cycle {

struct Submersion {
  double potential = 0.0;     //!< lift of the ice that is pushed down [N]
  double friction = 0.0;      //!< of it along the bow and under the bottom [N]
  double drag = 0.0;          //!< of the water on ice that the bow pushes aside [N]
  double mean_depth = 0.0;    //!< to which the strip of the ship's width is taken [m]
  double under_bottom = 0.0;  // its part that ends under the bottom; the rest passes along the sides

  double total() const { return potential + friction + drag; }
};

// Resistances. `length` is the ship's [m]: ice lies against 0.7 of it, as Lindqvist (1989) has it.
Submersion submersion(const QuadMesh& hull, const Ice& ice, double speed, double length);

}  // namespace icebow::cycle
