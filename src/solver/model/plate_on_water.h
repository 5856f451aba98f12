// The endless elastic plate afloat: Wyman 1950 (small disc), with shear as of Mindlin 1951.
#pragma once

namespace icebow {

struct PlateOnWater {
  double bending = 0.0;     //!< D = E h^3 / (12 (1 - nu^2)) [N m]
  double shear = 0.0;       //!< 5/6 G h [N/m]
  double foundation = 0.0;  //!< rho_w g [N/m^3]
};

PlateOnWater plate_on_water(double E, double nu, double h, double rho_w);

// ell = (D / (rho_w g))^(1/4) [m].
double characteristic_length(const PlateOnWater& plate);

// At distance r under a force of 1 N spread evenly over a disc of that radius about r = 0 [m/N]. For a small
// disc and a thin plate it is Hertz's 1 / (8 rho_w g ell^2) at r = 0. The radius is above 0.
double deflection_under_disc(const PlateOnWater& plate, double radius, double r);

}  // namespace icebow
