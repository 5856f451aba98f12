// Ice of 1 m, 1.3 GPa, 863 kPa and 2.6 MPa at a scale of 25, as the virtual tests calibrate the lattice for
// it: the plate's modulus and the held beam's strength are what theory is given.
#pragma once

#include <map>

#include "solver/tank/virtual_tests.h"
#include "tests/support/ice_block.h"
#include "tests/support/plate_elements.h"

namespace icebow {

struct TankIce {
  double h = 0.04, modulus = 52e6, strength = 34520.0, crushing = 104e3, nu = 0.33, rho = 826.6,
         water = 1000.0;
  double added_mass = 0.16;  //!< [m]

  double unit_load() const { return strength * h * h; }
  ThinPlate plate() const { return thin_plate(modulus, nu, h, rho, water, added_mass); }
  double characteristic_length() const { return plate().characteristic_length(); }
};

// nx by ny columns, free all round.
inline Scenario calibrated_sheet(int layers, int nx, int ny) {
  const TankIce ice;
  static std::map<int, IceMaterial> known;
  if (known.find(layers) == known.end()) {
    Scenario s = block_scenario(1, 1, layers, ice.h / layers);
    s.ice.tensile_strength = ice.strength;
    IceMaterial found = s.ice;
    found.E *= ice.modulus / virtual_plate_test(s);
    found.tensile_strength *= ice.strength / virtual_beam_test(s).flexural_strength;
    found.s0 = 0.0;
    found.crushing_pressure = ice.crushing;
    known[layers] = found;
  }
  Scenario s = block_scenario(nx, ny, layers, ice.h / layers);
  s.ice = known[layers];
  s.water.added_mass = ice.added_mass;
  return s;
}

}  // namespace icebow
