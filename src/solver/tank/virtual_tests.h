// Standard tests of ice properties, done with the solver's own lattice and bonds, quasi-static.
//
// Source: ITTC 7.5-02-04-02 (2014), Test Methods for Model Ice Properties: the in-situ cantilever beam, some
// 7 thicknesses long and 2 wide, the plate's deflection, and the uniaxial compression of a prism. See
// docs/theory.md, "Ice by its tests". Of a scenario its ice and numerics count. A piece is lround(h / dx)
// layers thick, two at least, and its thickness is theirs. Dry, no weight and no water, where nothing else is
// said. Throws InputError for a single layer, which cannot bend.
#pragma once

#include "solver/model/scenario.h"
#include "solver/tank/beam_test.h"

namespace icebow {

constexpr int most_tested_layers = 6;  // a beam of more takes many minutes

// At which the scenario's bonds break, given or from its toughness, eq. (8).
double critical_stretch(const Scenario& scenario);

// Root held, the tip moved up.
BeamTest virtual_beam_test(const Scenario& scenario);

enum class Push { up, down };
enum class SheetEdges { held, floating };

// The sheet around an in-situ beam, in thicknesses: behind the root, on either side and ahead of the tip. Its
// outermost columns behind and beside are held, or it ends afloat.
struct SheetAround {
  int behind = 6, beside = 6, ahead = 1;
  SheetEdges edges = SheetEdges::held;
};

// A beam whose root is the sheet, afloat: the bonds through two cuts along its sides and one across its tip
// are gone, and the tip is moved. (29) as for the held root, so what the sheet gives way counts as the
// beam's. The port half is computed.
BeamTest virtual_in_situ_test(const Scenario& scenario, Push push, const SheetAround& around = {});

// Modulus of the unbroken beam in a sheet so large that its end hardly matters [Pa]. A sheet that suffices
// for the strength is too small for this: the whole sheet turns and sinks under the beam's root.
double in_situ_modulus(const Scenario& scenario, const SheetAround& around = {20, 20, 20, SheetEdges::held});

// A square sheet afloat, simply supported, with a load over a disc of radius h in its middle. Modulus of the
// endless plate on water (plate_on_water.h) that goes down as far there [Pa]. The ice is made so soft that
// its characteristic length is `ell` thicknesses, as the modulus goes with E; `width` in those lengths.
double virtual_plate_test(const Scenario& scenario, double ell = 4.0, double width = 8.0);

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
