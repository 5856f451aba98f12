// What surrounds an ice tank's tests makes of their results: how large the sheet is, where the edges come
// from.
//
//   bench/tank_tests [LAYERS]          2 to 6, default 3
//
// Model ice of 40 mm, 35 MPa and 35 kPa by the held beam, that breaks by stress. Every figure is over that of
// the beam that is held at its root and is a body of its own. Minutes with three layers.
#include <cstdio>
#include <cstdlib>

#include "solver/tank/virtual_tests.h"
#include "tests/support/held_beam.h"

using namespace icebow;

namespace {

constexpr double E = 35e6, strength = 35e3;

Scenario tank_ice(int layers) {
  Scenario s = stress_ice(layers);
  const BeamTest beam = virtual_beam_test(s);
  s.ice.E *= E / beam.elastic_modulus;
  s.ice.tensile_strength *= strength / beam.flexural_strength;
  return s;
}

// So stiff that the water carries nothing.
Scenario without_water(Scenario s) {
  s.ice.E *= 1e4;
  s.ice.tensile_strength *= 1e4;
  return s;
}

void print(const char* name, double modulus, double flexural) {
  std::printf("%-46s %8.3f %8.3f\n", name, modulus, flexural);
  std::fflush(stdout);
}

void print_in_situ(const Scenario& s, int around, int ahead, double unit) {
  char name[64];
  std::snprintf(name, sizeof name, "in situ, sheet held %d h around%s", around,
                unit > 1.0 ? ", without water" : "");
  const BeamTest beam = virtual_in_situ_test(s, Push::up, {around, around, ahead, SheetEdges::held});
  print(name, beam.elastic_modulus / (unit * E), beam.flexural_strength / (unit * strength));
}

}  // namespace

int main(int argc, char** argv) {
  const int layers = argc > 1 ? std::atoi(argv[1]) : 3;
  const Scenario s = tank_ice(layers);
  std::printf("%d layers, over the held beam's                 modulus strength\n", layers);
  for (const int width : {2, 4}) {
    const BeamTest own = held_beam(s, width * layers, Sides::own),
                   cut = held_beam(s, width * layers, Sides::cut);
    print(width == 2 ? "cut out, 2 h wide" : "cut out, 4 h wide (over the same of its own)",
          cut.elastic_modulus / own.elastic_modulus, cut.flexural_strength / own.flexural_strength);
  }
  print_in_situ(without_water(s), 3, 1, 1e4);
  print_in_situ(without_water(s), 6, 1, 1e4);
  for (const int around : {3, 6, 10}) print_in_situ(s, around, 1, 1.0);
  print_in_situ(s, 20, 20, 1.0);
  for (const double ell : {4.0, 6.0, 8.0})
    std::printf("plate of 8 l, l = %g h: modulus over the held beam's %.3f\n", ell,
                virtual_plate_test(s, ell) / E);
}
