#include "solver/model/plate_on_water.h"

#include <cmath>

#include "base/units.h"

namespace icebow {

PlateOnWater plate_on_water(double E, double nu, double h, double rho_w) {
  return {E * h * h * h / (12.0 * (1.0 - nu * nu)), 5.0 / 6.0 * h * E / (2.0 * (1.0 + nu)), rho_w * gravity};
}

double characteristic_length(const PlateOnWater& p) {
  return std::pow(p.bending / p.foundation, 0.25);
}

// Hankel transform of k w + D del^4 w / (1 - (D/S) del^2) = pressure.
double deflection_under_disc(const PlateOnWater& p, double radius, double r) {
  const double per_length = 1.0 / characteristic_length(p), dt = 0.01 * per_length;
  double sum = 0.0;
  for (double t = 0.5 * dt; t < 60.0 * per_length; t += dt) {
    const double pressure =
        2.0 * std::cyl_bessel_j(1.0, t * radius) / (t * radius) * std::cyl_bessel_j(0.0, t * r);
    sum +=
        pressure * t * dt / (p.foundation + p.bending * std::pow(t, 4) / (1.0 + p.bending / p.shear * t * t));
  }
  return sum / (2.0 * pi);
}

}  // namespace icebow
