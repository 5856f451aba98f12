// The water's reaction to a block's columns, for the passes of kernel.h: equation (41) of docs/theory.md.
#pragma once

#include <cstddef>

#include "solver/lattice/lattice.h"

namespace icebow {

struct WaterLaw {
  double added_mass = 0.0;  //!< of a wet face [kg]
  double drag = 0.0;        //!< of both faces, over the speed squared [kg/m]
  double thickness = 0.0;   //!< of the ice [m]
  bool plane = false;       // ice in the sheet's plane has a share in the plane's water
  double mass = 0.0;        //!< of a particle [kg]
  double dx = 0.0;          //!< [m]
  double dt = 0.0;          //!< [s]
  double gravity = 0.0;     //!< [m/s^2]
  double lift = 0.0;        //!< (rho_w/rho) g [m/s^2]
  double z0 = 0.0;          //!< height of the lowest layer afloat [m]
};

// The fields of a block's columns, at the first particle of the lowest layer.
template <class Real>
struct WaterFields {
  const Real* u[3];
  const Real* v[3];
  Real* acceleration[3];  // of all forces but the water's, weight and lift
  std::ptrdiff_t layer;   // elements to the layer above
  int layers;
};

// A block's columns, along their normals.
struct WaterColumns {
  double n[3][block];
  double mass[block];     //!< with the own added mass [kg]; 0 where the water does nothing
  double share[block];    // that lies in the plane
  double v[block];        //!< mean velocity [m/s]
  double a[block];        //!< acceleration of all forces but the water's [m/s^2]
  double reached[block];  //!< acceleration with the strike, own added mass and drag [m/s^2]
  double change[block];   //!< what the water adds to it [m/s^2]
};

// What the hull did to the columns' velocities in this step [m/s].
struct WaterStrikes {
  double delta_v[3][block] = {};
};

}  // namespace icebow
