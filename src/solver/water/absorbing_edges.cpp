#include "solver/water/absorbing_edges.h"

#include <algorithm>
#include <cmath>

#include "solver/model/plate_on_water.h"

namespace icebow {
namespace {

// For which a flexural wave of the sheet's characteristic length that crosses the damped ice twice is left
// with a tenth of its amplitude. Amplitudes decay by exp(-1/2 integral of the rate over time); the rate grows
// with the square of the distance into the damped ice, so that the damping itself reflects little.
double rate_at_edge(const Scenario& s) {
  constexpr double left_over = 0.1;
  const PlateOnWater plate = plate_on_water(s.ice.E, s.ice.nu, s.ice.h, s.water.rho);
  const double length = characteristic_length(plate),
               depth = s.water.inertia == WaterInertia::plane ? length : s.water.added_mass;
  // Group velocity of D k^4 + rho_w g = m omega^2 at k = 1/l, the mass m taken as that wave's for all.
  const double mass = s.ice.rho * s.ice.h + s.water.rho * depth;
  const double speed = length * std::sqrt(2.0 * plate.foundation / mass);
  return 3.0 * std::log(1.0 / left_over) * speed / s.sheet.absorbing;
}

}  // namespace

AbsorbingEdges::AbsorbingEdges(const Scenario& s, const EnergyModel& model)
    : model_(model), width_(s.sheet.absorbing), rate_(acts() ? rate_at_edge(s) : 0.0) {}

double AbsorbingEdges::rate_at(double distance) const {
  const double depth = std::max(0.0, 1.0 - distance / width_);
  return rate_ * depth * depth;
}

double AbsorbingEdges::damp(IceSheet& sheet, std::size_t p, double z, double rate) const {
  double joules = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double v = sheet.v[c][p], damped = sheet.acceleration[c][p] - rate * v;
    const double total = damped + (c == 2 ? model_.weight_and_lift(z) : 0.0);
    sheet.acceleration[c][p] = damped;
    joules += model_.mass * rate * v * (v + 0.5 * model_.dt * total) * model_.dt;
  }
  return joules;
}

std::int64_t AbsorbingEdges::apply(IceSheet& sheet) const {
  const Lattice& lattice = sheet.lattice;
  const Layout& layout = sheet.layout;
  const double side = 0.5 * lattice.width(), end = (lattice.first + lattice.nx) * lattice.dx;
  std::int64_t taken = 0;
  for (int jl = 0; jl < layout.columns; ++jl) {
    const double from_side = side - std::abs(lattice.y(layout.j0 + jl));
    for (int l = 0; l < layout.blocks * block; ++l) {
      const double rate = rate_at(std::min(from_side, end - lattice.x(layout.i0 + l)));
      if (rate == 0.0 || !sheet.mobile(jl, l)) continue;
      double joules = 0.0;
      for (int k = 0; k < layout.nz; ++k) {
        const std::size_t p = layout.row(jl, k) + l;
        joules += damp(sheet, p, lattice.z(k) + sheet.u[2][p], rate);
      }
      taken += model_.quanta(joules);
    }
  }
  return taken;
}

}  // namespace icebow
