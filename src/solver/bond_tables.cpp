#include "solver/bond_tables.h"

#include <algorithm>

namespace icebow {
namespace {

// The factors of a bond end depend on edges within `reach`, and the other end lies within `reach` again.
constexpr int influence = 2 * reach;

class WeightBuilder {
 public:
  WeightBuilder(const Lattice& lattice, const Stencil& stencil, const Material& material,
                const BondTableOptions& options)
      : lattice_(lattice), stencil_(stencil), m_(material), options_(options) {}

  // Weights of the bond from particle (i, j, k) along the offset; zero where the neighbour does not exist.
  void write(int i, int j, int k, const Offset& o, float* dilatation, float* pressure, float* distortion) {
    *dilatation = *pressure = *distortion = 0.0f;
    const int i2 = i + o.di, j2 = j + o.dj, k2 = k + o.dk;
    if (i >= lattice_.nx || i2 < 0 || i2 >= lattice_.nx || j2 < 0 || j2 >= lattice_.ny) return;
    double G_d = 1.0, G_b = 1.0;
    if (options_.surface_correction) {
      const SurfaceFactors &g1 = factors(i, j, k), &g2 = factors(i2, j2, k2);
      G_d = bond_factor(g1.dilatation, g2.dilatation, o, lattice_.dx);
      G_b = bond_factor(g1.distortion, g2.distortion, o, lattice_.dx);
    }
    const double V = lattice_.particle_volume() * o.volume_factor;
    *dilatation = static_cast<float>(m_.d * m_.delta * V * G_d);
    // One 1/L belongs to the pressure term, the other to y/|y| = (xi + eta) R / L.
    *pressure =
        static_cast<float>(2.0 * m_.delta * m_.d * m_.a * G_d * V / (o.length * o.length * options_.rho));
    *distortion = static_cast<float>(4.0 * m_.delta * m_.b * G_b * V / (o.length * options_.rho));
  }

 private:
  const SurfaceFactors& factors(int i, int j, int k) {
    const auto near = [](int distance) { return std::min(distance, reach); };
    const EdgeDistance where{near(i), near(lattice_.nx - 1 - i), near(j), near(lattice_.ny - 1 - j), k};
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

}  // namespace

BondTables::BondTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                       const Material& material, const BondTableOptions& options)
    : ny_(lattice.ny), j0_(layout.j0), slots_(lattice.nz) {
  for (int k = 0; k < lattice.nz; ++k) {
    for (const Offset& o : stencil.layer[k]) {
      SlotGeometry g;
      g.neighbour = (std::ptrdiff_t(o.dj) * layout.nz + o.dk) * layout.stride + o.di;
      g.xi[0] = static_cast<float>(o.di * lattice.dx);
      g.xi[1] = static_cast<float>(o.dj * lattice.dx);
      g.xi[2] = static_cast<float>(o.dk * lattice.dx);
      for (int c = 0; c < 3; ++c) g.two_xi[c] = 2.0f * g.xi[c];
      g.inverse_L2 = static_cast<float>(1.0 / (o.length * o.length));
      slots_[k].push_back(g);
    }
  }

  WeightBuilder builder(lattice, stencil, material, options);
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < lattice.nz; ++k) {
      auto [entry, is_new] = weights_.try_emplace(row_class(jl, k));
      if (!is_new) continue;
      Weights& w = entry->second;
      const std::vector<Offset>& offsets = stencil.layer[k];
      const int j = layout.j0 + jl, n = static_cast<int>(offsets.size());
      w.lanes.assign(layout.blocks, nullptr);
      for (int b = 0; b < layout.blocks; ++b) {
        const int first = layout.i0 + b * block, last = first + block - 1;
        const bool interior = first >= influence && last <= lattice.nx - 1 - influence;
        if (interior && !w.interior.empty()) continue;
        if (interior) {
          w.interior.resize(std::size_t(n) * weights_per_slot);
          for (int s = 0; s < n; ++s) {
            float* out = &w.interior[std::size_t(s) * weights_per_slot];
            builder.write(first, j, k, offsets[s], out + dilatation_weight, out + pressure_weight,
                          out + distortion_weight);
          }
          continue;
        }
        std::vector<float>& table = w.ends[b];
        table.resize(std::size_t(n) * weights_per_slot * block);
        for (int s = 0; s < n; ++s) {
          float* out = &table[std::size_t(s) * weights_per_slot * block];
          for (int l = 0; l < block; ++l) {
            builder.write(first + l, j, k, offsets[s], out + dilatation_weight * block + l,
                          out + pressure_weight * block + l, out + distortion_weight * block + l);
          }
        }
        w.lanes[b] = table.data();
      }
    }
  }
}

BondTables::RowClass BondTables::row_class(int jl, int k) const {
  const int j = j0_ + jl;
  return {std::min(j, influence), std::min(ny_ - 1 - j, influence), k};
}

RowTables BondTables::row(int jl, int k) const {
  const Weights& w = weights_.at(row_class(jl, k));
  return {slots_[k].data(), static_cast<int>(slots_[k].size()), w.interior.data(), w.lanes.data()};
}

}  // namespace icebow
