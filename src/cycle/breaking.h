// When an edge of ice that is pressed down breaks, and how long the piece is. docs/cycle.md, (C6) to (C11).
#pragma once

#include "cycle/cycle_input.h"

namespace icebow::cycle {

struct Capacity {
  double load = 0.0;    //!< vertical load on the edge that breaks it [N]
  double radius = 0.0;  //!< of the piece, from the contact, without scatter [m]
};

struct Press {
  double width = 0.0;         //!< of the contact along the edge [m]
  double normal_speed = 0.0;  //!< V n_x of the hull there [m/s]
  double edge_speed = 0.0;    //!< with which the hull drives the edge down [m/s]
};

Capacity capacity(const Ice& ice, const BreakingRule& rule, const Press& press);

// No piece is longer than this without scatter [m].
double largest_radius(const Ice& ice, const BreakingRule& rule);

// Load on the free edge of the floating plate over its deflection there [N/m], (C4).
double edge_stiffness(const Ice& ice);

// Above this edge speed [m/s] the water's inertia breaks the plate short, whatever the width.
double inertial_speed(const Ice& ice);

}  // namespace icebow::cycle
