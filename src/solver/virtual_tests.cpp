#include "solver/virtual_tests.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/units.h"
#include "solver/tearing.h"

namespace icebow {
namespace {

constexpr int beam_length = 7, beam_width = 2;    // over the thickness
constexpr int prism_length = 4, prism_width = 2;  // likewise
constexpr int clamp = reach;                      // columns held at the root: as many as a bond can reach
// Unbalanced forces at an equilibrium. At 1e-4 the crack has not felt its last bond when the next one goes:
// the strength comes out a tenth higher.
constexpr double balance = 1e-6;
constexpr double together = 1e-3;  // bonds this near to the most stretched break with it: its mirror images
constexpr double fallen = 0.8;     // of the highest load: the test is over

// nx by ny particles of the scenario's ice, as thick as its sheet.
Scenario piece(const Scenario& s, int nx, int ny, int layers) {
  Scenario p;
  p.ice = s.ice;
  p.ice.h = layers * s.numerics.dx;
  p.numerics = s.numerics;
  p.numerics.linear_below = 0.0;  // the displacements are linear as they are
  p.sheet = {nx * s.numerics.dx, ny * s.numerics.dx, FixedEdges::none};
  p.V = 1.0;  // energies are not asked for
  return p;
}

int layers_of(const Scenario& s) {
  const int layers = static_cast<int>(std::lround(s.ice.h / s.numerics.dx));
  if (layers < 2) {
    throw InputError("ice of " + std::to_string(layers) +
                     " layer cannot bend, so no beam of it has a flexural strength: ask for two layers or "
                     "more (/solver/layers)");
  }
  return layers;
}

struct Failure {
  double first = 0.0, highest = 0.0;  // load before the first bond breaks; at the peak
  int breaks = 0;
};

// Breaks bonds until the load the piece carries is well below its highest. load() is the support's at the
// displacements given, between which and the break everything is in proportion.
template <class MayBreak, class Load>
Failure fail(StillIce& ice, const MayBreak& may_break, const Load& load) {
  Failure failure;
  for (double now = 0.0; now >= fallen * failure.highest; ++failure.breaks) {
    ice.settle(balance);
    const double demand = largest_demand(ice, may_break);
    if (!(demand > 0.0)) break;
    const double unit = load();
    now = unit / demand;
    if (failure.breaks == 0) failure.first = unit;
    failure.highest = std::max(failure.highest, now);
    break_above(ice, (1.0 - together) * demand, may_break);
  }
  return failure;
}

}  // namespace

BeamTest virtual_beam_test(const Scenario& scenario) {
  const int layers = layers_of(scenario), last = clamp + beam_length * layers - 1, ny = beam_width * layers;
  const Scenario s = piece(scenario, last + 1, ny, layers);
  StillIce beam(s);
  const auto tip = [&](int i, int, int) { return i == last; };
  const double dx = s.numerics.dx, h = s.ice.h, b = ny * dx, L = (beam_length * layers - 0.5) * dx;
  const double deflection = dx;
  beam.hold([](int i, int, int) { return i < clamp; });
  beam.hold_along(tip, 2, deflection);
  // What the tip's grip tears off is not the beam's strength.
  const auto away_from_tip = [&](int i, int, int, const Offset& o) {
    return std::max(i, i + o.di) < last - 2;
  };
  const Failure failure = fail(beam, away_from_tip, [&] { return beam.support(tip).z(); });
  // Deflection by bending, 4 F L^3 / (E b h^3), and by shear, F L / (5/6 G b h).
  const double shear = 2.0 * (1.0 + s.ice.nu) * 6.0 / 5.0 * L / (b * h);
  const double stiffness = failure.first / deflection;
  return {stiffness * (4.0 * std::pow(L / h, 3.0) / b + shear), 6.0 * failure.highest * L / (b * h * h),
          failure.breaks};
}

CompressionTest virtual_compression_test(const Scenario& scenario) {
  const int layers = layers_of(scenario), nx = prism_length * layers, ny = prism_width * layers;
  const Scenario s = piece(scenario, nx, ny, layers);
  StillIce prism(s);
  const auto near_plate = [&](int i, int, int) { return i == 0; };
  const auto far_plate = [&](int i, int, int) { return i == nx - 1; };
  prism.hold_along(near_plate, 0, 0.0);
  prism.hold_along(far_plate, 0, -s.numerics.dx);
  const auto any = [](int, int, int, const Offset&) { return true; };
  const Failure failure = fail(prism, any, [&] { return -prism.support(far_plate).x(); });
  const double inner = failure.highest / (ny * s.numerics.dx * s.ice.h), crushing = s.ice.crushing_pressure;
  return {crushing > 0.0 ? std::min(inner, crushing) : inner, failure.breaks};
}

double buoyancy_share(double E, double h, double rho_w) {
  const double L = beam_length * h;
  return 33.0 / 140.0 * rho_w * gravity * std::pow(L, 4.0) / (0.25 * E * h * h * h);
}

}  // namespace icebow
