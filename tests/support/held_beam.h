// A cantilever held at its root, dry: a body of its own, or cut out of a wider slab by taking bonds away.
#pragma once

#include <algorithm>

#include "solver/tank/cantilever.h"
#include "solver/tank/specimen.h"
#include "tests/support/ice_block.h"

namespace icebow {

enum class Sides { own, cut };  // whether the surface correction knows of them

// 7 h long, of that many columns. What is beside a cut is held and has no part in it.
inline BeamTest held_beam(const Scenario& scenario, int columns, Sides sides) {
  const int layers = tested_layers(scenario), last = reach + beam_length * layers - 1,
            beside = sides == Sides::cut ? edge_influence : 0;
  const Scenario s = specimen(scenario, last + 1, columns + 2 * beside, layers);
  const auto in_beam = [&](int j) { return j >= beside && j < beside + columns; };
  const auto tip = [&](int i, int j, int) { return i == last && in_beam(j); };
  StillIce beam(s);
  cut(beam.ice.sheet, [&](int, int j, int, const Offset& o) { return in_beam(j) != in_beam(j + o.dj); });
  beam.hold([&](int i, int j, int) { return i < reach || !in_beam(j); });
  const double dx = s.numerics.dx;
  beam.hold_along(tip, 2, dx);
  const Failure failure = tear_until_it_fails(
      beam, [&](int i, int, int, const Offset& o) { return std::max(i, i + o.di) < last - 2; },
      [&] { return beam.support(tip).z(); });
  return beam_test({(beam_length * layers - 0.5) * dx, columns * dx, s.ice.h, s.ice.nu}, failure.first / dx,
                   failure);
}

// Ice that breaks by stress, as calibrated ice does; 40 mm thick.
inline Scenario stress_ice(int layers) {
  Scenario s = block_scenario(1, 1, layers, 0.04 / layers);
  s.ice.tensile_strength = 35e3;
  return s;
}

}  // namespace icebow
