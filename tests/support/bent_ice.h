// What bends: a cantilever's modulus and a sheet's flexural rigidity, found by loading pieces of ice at rest.
#pragma once

#include <map>
#include <utility>

#include "solver/tank/still_ice.h"
#include "tests/support/ice_block.h"

namespace icebow {

inline Scenario bent_piece(int nx, int ny, int layers, bool corrected) {
  Scenario s = block_scenario(nx, ny, layers);
  s.numerics.surface_correction = corrected;
  return s;
}

inline double rigidity(const IceMaterial& ice) {  // D of plate theory [N m]
  return ice.E * ice.h * ice.h * ice.h / (12.0 * (1.0 - ice.nu * ice.nu));
}

constexpr int clamped = 3;  // columns that are held, as at a sheet's fixed edge

// Mean over width and thickness.
inline double deflection(const StillIce& ice, int i) {
  const Lattice& l = ice.ice.lattice;
  double sum = 0.0;
  for (int j = 0; j < l.ny; ++j) {
    for (int k = 0; k < l.nz; ++k) sum += ice.u(i, j, k).z();
  }
  return sum / (l.ny * l.nz);
}

// E of the Euler-Bernoulli beam with the curvature of a cantilever of 12 h half-way to its loaded tip. There
// neither the clamp nor the constant shear has a part in it.
inline double beam_modulus(int layers, int ny, bool corrected) {
  const int free = 12 * layers, last = clamped + free - 1, half_way = clamped + free / 2, span = free / 4;
  const Scenario s = bent_piece(last + 1, ny, layers, corrected);
  StillIce beam(s);
  beam.hold([](int i, int, int) { return i < clamped; });
  beam.push([&](int i, int, int) { return i == last; }, {0.0, 0.0, 1.0});
  beam.settle();
  const double dx = s.numerics.dx, h = s.ice.h;
  const double curvature = (deflection(beam, half_way - span) - 2.0 * deflection(beam, half_way) +
                            deflection(beam, half_way + span)) /
                           (span * span * dx * dx);
  return (last - half_way) * dx / (curvature * ny * dx * h * h * h / 12.0);
}

// Deflection at the middle of a square plate, n x n particles between clamped edges, under a force of 1 N
// spread evenly.
inline double clamped_plate_deflection(int n, int layers, bool corrected) {
  const int all = n + 2 * clamped;
  StillIce plate(bent_piece(all, all, layers, corrected));
  const auto held = [&](int i, int j, int) {
    return i < clamped || j < clamped || i >= clamped + n || j >= clamped + n;
  };
  plate.hold(held);
  plate.push([&](int i, int j, int k) { return !held(i, j, k); }, {0.0, 0.0, 1.0});
  plate.settle(1e-5);
  double sum = 0.0;
  for (int i : {all / 2 - 1, all / 2}) {
    for (int j : {all / 2 - 1, all / 2}) {
      for (int k = 0; k < layers; ++k) sum += plate.u(i, j, k).z() / (4.0 * layers);
    }
  }
  return sum;
}

// D over that of plate theory, as two clamped plates of 12 h and 20 h show it. Bending goes with (a + c)^4:
// where exactly the clamp begins, c, is found with D. Coefficients: Timoshenko and Woinowsky-Krieger 1959,
// table 35, and Reissner's shear, 0.0737 q a^2 / (5/6 G h).
inline double plate_rigidity_found(int layers, bool corrected) {
  const int n[2] = {12 * layers, 20 * layers};
  const Scenario s = bent_piece(40, 40, layers, corrected);
  const double dx = s.numerics.dx, G = s.ice.E / (2.0 * (1.0 + s.ice.nu));
  double root[2];  // of the deflection by bending under unit pressure, ~ a + c
  for (int p = 0; p < 2; ++p) {
    const double a = n[p] * dx, shear = 0.0737 / (5.0 / 6.0 * G * s.ice.h);
    root[p] = std::pow((clamped_plate_deflection(n[p], layers, corrected) - shear) * a * a, 0.25);
  }
  const double per_length = (root[1] - root[0]) / ((n[1] - n[0]) * dx);
  return 0.001265 / std::pow(per_length, 4.0) / rigidity(s.ice);
}

inline double plate_rigidity(int layers, bool corrected) {  // found once
  static std::map<std::pair<int, bool>, double> known;
  const auto [entry, is_new] = known.try_emplace({layers, corrected});
  if (is_new) entry->second = plate_rigidity_found(layers, corrected);
  return entry->second;
}

}  // namespace icebow
