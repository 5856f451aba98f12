#include <cmath>

#include "base/units.h"
#include "solver/model/plate_on_water.h"
#include "solver/tank/specimen.h"
#include "solver/tank/still_ice.h"
#include "solver/tank/virtual_tests.h"

namespace icebow {
namespace {

// The scenario's ice as a square sheet of such softness; the port half.
Scenario soft_sheet(const Scenario& scenario, int layers, double ell, double width) {
  const int n = 2 * static_cast<int>(std::lround(0.5 * width * ell * layers));
  Scenario s = specimen(scenario, n, n, layers);
  const PlateOnWater of_unit_modulus = plate_on_water(1.0, s.ice.nu, s.ice.h, s.water.rho);
  s.ice.E = std::pow(ell * s.ice.h / characteristic_length(of_unit_modulus), 4.0);
  s.ice.tensile_strength = s.ice.K_I = 0.0;
  s.ice.s0 = 0.01;  // any: nothing breaks
  s.numerics.linear_below = scenario.numerics.linear_below;
  s.sheet.half_model = true;
  return s;
}

// Squared distance from the middle of the sheet, which lies between four columns, in spacings.
double squared_distance(const Lattice& l, int i, int j) {
  const double x = i + 0.5 - 0.5 * l.nx, y = j + 0.5;
  return x * x + y * y;
}

bool loaded(const Lattice& l, int i, int j) {
  return squared_distance(l, i, j) < l.nz * l.nz;
}

// That of the loaded columns, the lattice's rough edge smoothed [m].
double load_radius(const Lattice& l) {
  int columns = 0;
  for (int i = 0; i < l.nx; ++i) {
    for (int j = 0; j < l.ny; ++j) columns += l.copies() * loaded(l, i, j);
  }
  return std::sqrt(columns / pi) * l.dx;
}

// How far the four columns in the middle go down under a force of 1 N [m].
double deflection(const Scenario& s) {
  StillIce plate(s, Surroundings::water);
  const Lattice& l = plate.ice.lattice;
  plate.hold_along([&](int i, int j, int) { return i == 0 || i == l.nx - 1 || j == l.ny - 1; }, 2, 0.0);
  plate.push([&](int i, int j, int) { return loaded(l, i, j); }, {0.0, 0.0, 1.0 / l.copies()});
  plate.settle(1e-6);
  double sum = 0.0;
  for (int k = 0; k < l.nz; ++k) sum += plate.u(l.nx / 2 - 1, 0, k).z() + plate.u(l.nx / 2, 0, k).z();
  return sum / (2.0 * l.nz);
}

// Modulus with which theory(E) is the deflection, from one that is near it.
template <class Theory>
double modulus_of(double deflection, double E, const Theory& theory) {
  double ratio = 0.0;
  for (int n = 0; n < 50 && std::abs(ratio - 1.0) > 1e-9; ++n) {
    ratio = theory(E) / deflection;
    E *= ratio * ratio;  // Hertz: w goes with 1/sqrt(E)
  }
  return E;
}

}  // namespace

double virtual_plate_test(const Scenario& scenario, double ell, double width) {
  const Scenario s = soft_sheet(scenario, tested_layers(scenario), ell, width);
  const double radius = load_radius(make_lattice(s)), middle = std::sqrt(0.5) * s.numerics.dx;
  const auto theory = [&](double E) {
    return deflection_under_disc(plate_on_water(E, s.ice.nu, s.ice.h, s.water.rho), radius, middle);
  };
  return modulus_of(deflection(s), s.ice.E, theory) / s.ice.E * scenario.ice.E;
}

}  // namespace icebow
