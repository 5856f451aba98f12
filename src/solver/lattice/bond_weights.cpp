#include "solver/lattice/bond_weights.h"

#include <algorithm>

namespace icebow {

BondWeight BondWeights::operator()(int i, int j, int k, const Offset& o) {
  const int i2 = i + o.di, j2 = j + o.dj, k2 = k + o.dk;
  if (!exists(i, j) || !exists(i2, j2)) return {};
  double G_d = 1.0, G_b = 1.0;
  if (options_.surface_correction) {
    const SurfaceFactors &g1 = factors(i, j, k), &g2 = factors(i2, j2, k2);
    G_d = bond_factor(g1.dilatation, g2.dilatation, o, lattice_.dx);
    G_b = bond_factor(g1.distortion, g2.distortion, o, lattice_.dx);
  }
  const double V = lattice_.particle_volume() * o.volume_factor, L2 = o.length * o.length;
  // One 1/L belongs to the pressure term, the other to y/|y| = (xi + eta) R / L.
  return {m_.d * m_.delta * V * G_d, 2.0 * m_.delta * m_.d * m_.a * G_d * V / (L2 * options_.rho),
          4.0 * m_.delta * m_.b * G_b * V / (o.length * options_.rho)};
}

const SurfaceFactors& BondWeights::factors(int i, int j, int k) {
  const auto near = [](int distance) { return std::min(distance, reach); };
  const EdgeDistance where{near(i), near(lattice_.nx - 1 - i), near(j + lattice_.mirrored_columns()),
                           near(lattice_.ny - 1 - j), k};
  const auto key = std::make_tuple(where.x_lo, where.x_hi, where.y_lo, where.y_hi, k);
  const auto found = cache_.find(key);
  if (found != cache_.end()) return found->second;
  return cache_.emplace(key, surface_factors(where, stencil_, m_, lattice_.dx)).first->second;
}

}  // namespace icebow
