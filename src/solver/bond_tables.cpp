#include "solver/bond_tables.h"

#include <algorithm>

namespace icebow {
namespace {

// The factors of a bond end depend on edges within `reach`, and the other end lies within `reach` again.
constexpr int influence = 2 * reach;

template <class Real>
class TableBuilder {
 public:
  TableBuilder(const Lattice& lattice, const Stencil& stencil, const Material& material,
               const BondTableOptions& options)
      : lattice_(lattice), stencil_(stencil), m_(material), options_(options) {}

  // Tables of the bonds of particles (i .. i + particles - 1, j, k): [slot][constant][particle].
  std::vector<Real> table(int i, int j, int k, int particles) {
    std::vector<Real> table;
    for (const Offset& o : stencil_.half[k]) {
      const std::size_t first = table.size();
      table.resize(first + std::size_t(constants_per_slot) * particles);
      for (int p = 0; p < particles; ++p) {
        Real values[constants_per_slot];
        write(i + p, j, k, o, values);
        for (int c = 0; c < constants_per_slot; ++c) table[first + c * particles + p] = values[c];
      }
    }
    return table;
  }

 private:
  // Weights are zero where the bond does not exist.
  void write(int i, int j, int k, const Offset& o, Real* out) {
    const double xi[3] = {o.di * lattice_.dx, o.dj * lattice_.dx, o.dk * lattice_.dx},
                 L2 = o.length * o.length;
    std::fill(out, out + constants_per_slot, Real(0));
    for (int c = 0; c < 3; ++c) {
      out[xi_x + c] = static_cast<Real>(xi[c]);
      out[xi2_x + c] = 2 * out[xi_x + c];
    }
    out[inverse_L2] = static_cast<Real>(1.0 / L2);
    const int i2 = i + o.di, j2 = j + o.dj, k2 = k + o.dk;
    if (i < 0 || i >= lattice_.nx || i2 < 0 || i2 >= lattice_.nx || j2 < 0 || j2 >= lattice_.ny) return;
    double G_d = 1.0, G_b = 1.0;
    if (options_.surface_correction) {
      const SurfaceFactors &g1 = factors(i, j, k), &g2 = factors(i2, j2, k2);
      G_d = bond_factor(g1.dilatation, g2.dilatation, o, lattice_.dx);
      G_b = bond_factor(g1.distortion, g2.distortion, o, lattice_.dx);
    }
    const double V = lattice_.particle_volume() * o.volume_factor;
    // One 1/L belongs to the pressure term, the other to y/|y| = (xi + eta) R / L.
    const double dilatation = m_.d * m_.delta * V * G_d,
                 pressure = 2.0 * m_.delta * m_.d * m_.a * G_d * V / (L2 * options_.rho),
                 distortion = 4.0 * m_.delta * m_.b * G_b * V / (o.length * options_.rho);
    out[dilatation_weight] = static_cast<Real>(dilatation);
    out[pressure_weight] = static_cast<Real>(pressure);
    out[distortion_weight] = static_cast<Real>(distortion);
    out[calm_dilatation] = static_cast<Real>(0.5 * dilatation / L2);  // G(0) = H(0) = 1/2
    out[calm_distortion] = static_cast<Real>(0.5 * distortion / L2);
  }

  const SurfaceFactors& factors(int i, int j, int k) {
    const auto near = [](int distance) { return std::min(distance, reach); };
    const EdgeDistance where{near(i), near(lattice_.nx - 1 - i), near(j + lattice_.mirrored_columns()),
                             near(lattice_.ny - 1 - j), k};
    const auto key = std::make_tuple(where.x_lo, where.x_hi, where.y_lo, where.y_hi, k);
    const auto found = cache_.find(key);
    if (found != cache_.end()) return found->second;
    return cache_.emplace(key, surface_factors(where, stencil_, m_, lattice_.dx)).first->second;
  }

  const Lattice& lattice_;
  const Stencil& stencil_;
  const Material& m_;
  const BondTableOptions& options_;
  std::map<std::tuple<int, int, int, int, int>, SurfaceFactors> cache_;
};

// The least that a calm bond adds to theta, over its e: surface factors are at least about 1.
template <class Real>
Real theta_per_strain(const Lattice& lattice, const Stencil& stencil, const Material& m) {
  double smallest = 1.0;
  for (const Offset& o : stencil.family[0]) smallest = std::min(smallest, o.volume_factor);
  const double weight = m.d * m.delta * lattice.particle_volume() * smallest;
  return static_cast<Real>(0.5 * weight);
}

}  // namespace

template <class Real>
BondTables<Real>::BondTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                             const Material& material, const BondTableOptions& options)
    : ny_(lattice.ny),
      mirrored_columns_(lattice.mirrored_columns()),
      j0_(layout.j0),
      theta_per_strain_(theta_per_strain<Real>(lattice, stencil, material)),
      neighbour_(lattice.nz) {
  for (int k = 0; k < lattice.nz; ++k) {
    for (const Offset& o : stencil.half[k]) {
      neighbour_[k].push_back((std::ptrdiff_t(o.dj) * layout.nz + o.dk) * layout.stride + o.di);
    }
  }

  TableBuilder<Real> builder(lattice, stencil, material, options);
  const auto interior = [&](int first) {
    return first >= influence && first + block - 1 <= lattice.nx - 1 - influence;
  };
  for (int jl = -reach; jl < layout.columns; ++jl) {
    const int j = layout.j0 + jl;
    if (j < 0 && !lattice.half) continue;
    for (int k = 0; k < lattice.nz; ++k) {
      auto [entry, is_new] = tables_.try_emplace(row_class(jl, k));
      if (!is_new) continue;
      Tables& t = entry->second;
      t.end_of.assign(layout.blocks + 2, nullptr);
      for (int b = -1; b <= layout.blocks; ++b) {
        const int first = layout.i0 + b * block;
        if (interior(first)) {
          if (t.interior.empty()) t.interior = builder.table(first, j, k, 1);
          continue;
        }
        t.ends[b] = builder.table(first, j, k, block);
        t.end_of[1 + b] = t.ends[b].data();
      }
    }
  }
}

template <class Real>
typename BondTables<Real>::RowClass BondTables<Real>::row_class(int jl, int k) const {
  const int j = j0_ + jl;
  return {j < 0 ? j : std::min(j + mirrored_columns_, influence), std::min(ny_ - 1 - j, influence), k};
}

template <class Real>
RowTables<Real> BondTables<Real>::row(int jl, int k) const {
  const Tables& t = tables_.at(row_class(jl, k));
  return {static_cast<int>(neighbour_[k].size()), neighbour_[k].data(), t.interior.data(),
          t.end_of.data() + 1, theta_per_strain_};
}

template class BondTables<float>;
template class BondTables<double>;

}  // namespace icebow
