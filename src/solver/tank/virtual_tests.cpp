#include "solver/tank/virtual_tests.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "solver/tank/cantilever.h"
#include "solver/tank/specimen.h"
#include "solver/tank/tearing.h"

namespace icebow {
namespace {

constexpr int prism_length = 4, prism_width = 2;  // over the thickness
constexpr int clamp = reach;                      // columns held at the root: as many as a bond can reach

}  // namespace

double critical_stretch(const Scenario& s) {
  return make_material(s.ice, s.numerics.dx, s.numerics.horizon_ratio).s0;
}

BeamTest virtual_beam_test(const Scenario& scenario) {
  const int layers = tested_layers(scenario), last = clamp + beam_length * layers - 1,
            ny = beam_width * layers;
  const Scenario s = specimen(scenario, last + 1, ny, layers);
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
  const Failure failure = tear_until_it_fails(beam, away_from_tip, [&] { return beam.support(tip).z(); });
  return beam_test({L, b, h, s.ice.nu}, failure.first / deflection, failure);
}

CompressionTest virtual_compression_test(const Scenario& scenario) {
  const int layers = tested_layers(scenario), nx = prism_length * layers, ny = prism_width * layers;
  const Scenario s = specimen(scenario, nx, ny, layers);
  StillIce prism(s);
  const auto near_plate = [&](int i, int, int) { return i == 0; };
  const auto far_plate = [&](int i, int, int) { return i == nx - 1; };
  prism.hold_along(near_plate, 0, 0.0);
  prism.hold_along(far_plate, 0, -s.numerics.dx);
  const auto any = [](int, int, int, const Offset&) { return true; };
  const Failure failure = tear_until_it_fails(prism, any, [&] { return -prism.support(far_plate).x(); });
  const double inner = failure.highest / (ny * s.numerics.dx * s.ice.h), crushing = s.ice.crushing_pressure;
  return {crushing > 0.0 ? std::min(inner, crushing) : inner, failure.breaks};
}

double buoyancy_share(double E, double h, double rho_w) {
  const double L = beam_length * h;
  return 33.0 / 140.0 * rho_w * gravity * std::pow(L, 4.0) / (0.25 * E * h * h * h);
}

}  // namespace icebow
