#include "solver/kernel/bond_tables.h"

#include <algorithm>

namespace icebow {
namespace {

// Tables of the bonds of particles (i .. i + particles - 1, j, k): [slot][constant][particle].
template <class Real>
std::vector<Real> make_table(BondWeights& weights, const Lattice& lattice, const Stencil& stencil, int i,
                             int j, int k, int particles) {
  std::vector<Real> table;
  for (const Offset& o : stencil.half[k]) {
    const std::size_t first = table.size();
    table.resize(first + std::size_t(constants_per_slot) * particles);
    const auto xi = [&](int steps) { return static_cast<Real>(steps * lattice.dx); };
    const double L2 = o.length * o.length;
    for (int p = 0; p < particles; ++p) {
      const auto at = [&](SlotConstant c) -> Real& { return table[first + c * particles + p]; };
      at(xi_x) = xi(o.di);
      at(xi_y) = xi(o.dj);
      at(xi_z) = xi(o.dk);
      at(inverse_L2) = static_cast<Real>(1.0 / L2);
      const BondWeight w = weights(i + p, j, k, o);
      at(dilatation_weight) = static_cast<Real>(w.dilatation);
      at(pressure_weight) = static_cast<Real>(w.pressure);
      at(distortion_weight) = static_cast<Real>(w.distortion);
    }
  }
  return table;
}

}  // namespace

template <class Real>
BondTables<Real>::BondTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                             const Material& material, const BondTableOptions& options)
    : ny_(lattice.ny), mirrored_columns_(lattice.mirrored_columns()), j0_(layout.j0), neighbour_(lattice.nz) {
  for (int k = 0; k < lattice.nz; ++k) {
    for (const Offset& o : stencil.half[k]) {
      neighbour_[k].push_back((std::ptrdiff_t(o.dj) * layout.nz + o.dk) * layout.stride + o.di);
    }
  }

  BondWeights weights(lattice, stencil, material, options);
  const auto table = [&](int i, int j, int k, int particles) {
    return make_table<Real>(weights, lattice, stencil, i, j, k, particles);
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
        if (is_interior(lattice, first)) {
          if (t.interior.empty()) t.interior = table(first, j, k, 1);
          continue;
        }
        t.ends[b] = table(first, j, k, block);
        t.end_of[1 + b] = t.ends[b].data();
      }
    }
  }
}

template <class Real>
typename BondTables<Real>::RowClass BondTables<Real>::row_class(int jl, int k) const {
  const int j = j0_ + jl;
  return {j < 0 ? j : std::min(j + mirrored_columns_, edge_influence), std::min(ny_ - 1 - j, edge_influence),
          k};
}

template <class Real>
RowTables<Real> BondTables<Real>::row(int jl, int k) const {
  const Tables& t = tables_.at(row_class(jl, k));
  return {static_cast<int>(neighbour_[k].size()), neighbour_[k].data(), t.interior.data(),
          t.end_of.data() + 1};
}

template class BondTables<float>;
template class BondTables<double>;

}  // namespace icebow
