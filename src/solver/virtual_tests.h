// Standard tests of ice properties, done with the solver's own lattice and bonds, quasi-static.
//
// Source: ITTC 7.5-02-04-02 (2014), Test Methods for Model Ice Properties: the in-situ cantilever beam, some
// 7 thicknesses long and 2 wide, and the uniaxial compression of a prism. See docs/theory.md, "Ice by its
// tests". Of a scenario its ice and numerics count. A piece is lround(h / dx) layers thick, two at least, and
// its thickness is theirs. Dry: no weight, no water. Throws InputError for a single layer, which cannot bend.
#pragma once

#include "solver/scenario.h"

namespace icebow {

constexpr int most_tested_layers = 6;  // a beam of more takes many minutes

struct BeamTest {
  double elastic_modulus = 0.0;    //!< E of the Timoshenko cantilever as stiff as the unbroken one [Pa]
  double flexural_strength = 0.0;  //!< 6 F L / (b h^2) at the highest force [Pa]
  int breaks = 0;                  // equilibria that the piece went through
};
// Root held, the tip moved up.
BeamTest virtual_beam_test(const Scenario& scenario);

struct CompressionTest {
  // Highest mean pressure on the end faces: where the piece fails, or where its faces are crushed (crushing
  // rule), whichever comes first [Pa]
  double compressive_strength = 0.0;
  int breaks = 0;
};
// A prism 4 h long, 2 h wide and h thick between rigid smooth plates that press along the sheet.
CompressionTest virtual_compression_test(const Scenario& scenario);

// Part of the beam's stiffness that lifting it out of water would add, which the dry test leaves out: the
// cantilever on rho_w g b of foundation, 33/140 of it moving with the tip.
double buoyancy_share(double E, double h, double rho_w);

}  // namespace icebow
