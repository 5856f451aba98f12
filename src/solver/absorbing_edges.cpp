#include "solver/absorbing_edges.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace icebow {

// Amplitudes decay by exp(-1/2 integral of the rate over time); the rate grows with the square of the
// distance into the damped ice, so that the damping itself reflects little.
double absorbing_rate(const Scenario& s) {
  if (!(s.sheet.absorbing > 0.0)) return 0.0;
  constexpr double left_over = 0.1;
  const double D = s.ice.E * std::pow(s.ice.h, 3) / (12.0 * (1.0 - s.ice.nu * s.ice.nu));
  const double foundation = s.water.rho * gravity, l = std::pow(D / foundation, 0.25);
  const double mass = s.ice.rho * s.ice.h + s.water.rho * s.water.added_mass;
  // Group velocity of D k^4 + rho_w g = m omega^2 at k = 1/l.
  const double speed = l * std::sqrt(2.0 * foundation / mass);
  return 3.0 * std::log(1.0 / left_over) * speed / s.sheet.absorbing;
}

AbsorbingEdges::AbsorbingEdges(const Scenario& s, const EnergyModel& model)
    : model_(model), width_(s.sheet.absorbing), rate_(absorbing_rate(s)) {}

double AbsorbingEdges::rate_at(double distance) const {
  const double depth = std::max(0.0, 1.0 - distance / width_);
  return rate_ * depth * depth;
}

std::int64_t AbsorbingEdges::apply(IceSheet& sheet) const {
  const Lattice& lattice = sheet.lattice;
  const Layout& layout = sheet.layout;
  const double side = 0.5 * lattice.width(), end = (lattice.first + lattice.nx) * lattice.dx;
  std::int64_t taken = 0;
  for (int jl = 0; jl < layout.columns; ++jl) {
    const double from_side = side - std::abs(lattice.y(layout.j0 + jl));
    for (int b = 0; b < layout.blocks; ++b) {
      const double nearest = std::min(from_side, end - lattice.x(layout.i0 + (b + 1) * block - 1));
      if (nearest >= width_) continue;
      double joules = 0.0;
      for (int k = 0; k < layout.nz; ++k) {
        for (int l = b * block; l < (b + 1) * block; ++l) {
          if (!sheet.mobile(jl, l)) continue;
          const std::size_t p = layout.row(jl, k) + l;
          const double rate = rate_at(std::min(from_side, end - lattice.x(layout.i0 + l)));
          const double z = lattice.z(k) + sheet.u[2][p];
          for (int c = 0; c < 3; ++c) {
            const double v = sheet.v[c][p], with = sheet.acceleration[c][p] - rate * v;
            const double total = with + (c == 2 ? model_.weight_and_lift(z) : 0.0);
            sheet.acceleration[c][p] = with;
            joules += model_.mass * rate * v * (v + 0.5 * model_.dt * total) * model_.dt;
          }
        }
      }
      taken += model_.quanta(joules);
    }
  }
  return taken;
}

}  // namespace icebow
