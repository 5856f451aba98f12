#include "solver/lattice/stencil.h"

#include <cmath>

#include "base/units.h"

namespace icebow {

double critical_stretch(const IceMaterial& ice, double delta) {
  const double kappa = ice.E / (3.0 * (1.0 - 2.0 * ice.nu)), mu = ice.E / (2.0 * (1.0 + ice.nu));
  const double G_c = ice.K_I * ice.K_I / ice.E;
  return std::sqrt(G_c / ((3.0 * mu + std::pow(0.75, 4) * (kappa - 5.0 * mu / 3.0)) * delta));
}

Material make_material(const IceMaterial& ice, double dx, double horizon_ratio) {
  Material m;
  m.kappa = ice.E / (3.0 * (1.0 - 2.0 * ice.nu));
  m.mu = ice.E / (2.0 * (1.0 + ice.nu));
  m.delta = horizon_ratio * dx;
  m.a = 0.5 * (m.kappa - 5.0 * m.mu / 3.0);
  m.b = 15.0 * m.mu / (2.0 * pi * std::pow(m.delta, 5));
  m.d = 9.0 / (4.0 * pi * std::pow(m.delta, 4));
  m.s0 = ice.s0 > 0.0 ? ice.s0 : critical_stretch(ice, m.delta);
  m.tensile_strength = ice.tensile_strength;
  if (m.tensile_strength > 0.0) m.s0 = m.tensile_strength / ice.E;
  return m;
}

Stencil make_stencil(int nz, double dx, double horizon) {
  Stencil stencil;
  stencil.first_slot.push_back(0);
  const double ratio = horizon / dx;
  for (int k = 0; k < nz; ++k) {
    std::vector<Offset> family, half;
    for (int di = -reach; di <= reach; ++di) {
      for (int dj = -reach; dj <= reach; ++dj) {
        for (int dk = -reach; dk <= reach; ++dk) {
          const int squared = di * di + dj * dj + dk * dk;
          // |xi| <= horizon, decided on whole numbers so that rounding cannot drop the bonds at exactly 3 dx.
          if (squared == 0 || squared > ratio * ratio * (1.0 + 1e-9)) continue;
          if (k + dk < 0 || k + dk >= nz) continue;
          Offset o{di, dj, dk, dx * std::sqrt(double(squared)), 1.0};
          if (o.length > horizon - 0.5 * dx) o.volume_factor = (horizon + 0.5 * dx - o.length) / dx;
          family.push_back(o);
          if (dj > 0 || (dj == 0 && (dk > 0 || (dk == 0 && di > 0)))) half.push_back(o);
        }
      }
    }
    stencil.first_slot.push_back(stencil.first_slot.back() + static_cast<int>(half.size()));
    stencil.family.push_back(std::move(family));
    stencil.half.push_back(std::move(half));
  }
  return stencil;
}

SurfaceFactors surface_factors(const EdgeDistance& where, const Stencil& stencil, const Material& m,
                               double dx) {
  const double V = dx * dx * dx;
  std::array<double, 3> theta{}, energy{};  // per unit stretch along each axis
  for (const Offset& o : stencil.family[where.k]) {
    if (-o.di > where.x_lo || o.di > where.x_hi || -o.dj > where.y_lo || o.dj > where.y_hi) continue;
    const double xi[3] = {o.di * dx, o.dj * dx, o.dk * dx};
    for (int c = 0; c < 3; ++c) {
      const double s = xi[c] * xi[c] / (o.length * o.length);
      theta[c] += m.d * m.delta * V * o.volume_factor * s;
      energy[c] += m.b * m.delta * V * o.volume_factor * s * s * o.length;
    }
  }
  SurfaceFactors g;
  for (int c = 0; c < 3; ++c) {
    // A sheet of one layer has no bonds along z: such a family cannot be corrected, its bonds have n_z = 0
    // anyway.
    g.dilatation[c] = theta[c] > 0.0 ? 1.0 / theta[c] : 1.0;
    g.distortion[c] = energy[c] > 0.0 ? 1.5 * m.mu / energy[c] : 1.0;
  }
  return g;
}

double bond_factor(const std::array<double, 3>& end1, const std::array<double, 3>& end2, const Offset& o,
                   double dx) {
  const double n[3] = {o.di * dx / o.length, o.dj * dx / o.length, o.dk * dx / o.length};
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double g = 0.5 * (end1[c] + end2[c]);
    sum += n[c] * n[c] / (g * g);
  }
  return 1.0 / std::sqrt(sum);
}

}  // namespace icebow
