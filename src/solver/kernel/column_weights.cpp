#include "solver/kernel/column_weights.h"

#include <algorithm>
#include <cstdlib>

namespace icebow {

template <class Real>
std::vector<ColumnGroup<Real>> column_groups(const Layout& layout, const Stencil& stencil, double dx) {
  std::map<std::array<int, 2>, int> reaches;  // of a column of neighbours: how far up
  reaches[{0, 0}] = 0;
  for (const auto& family : stencil.family) {
    for (const Offset& o : family) {
      int& dk = reaches[{o.di, o.dj}];
      dk = std::max(dk, std::abs(o.dk));
    }
  }
  std::map<std::tuple<int, bool>, ColumnGroup<Real>> groups;
  for (const auto& [steps, dk] : reaches) {
    const auto [di, dj] = steps;
    const bool own = di == 0 && dj == 0;
    if (own && dk == 0) continue;
    ColumnGroup<Real>& group = groups[{dk, own}];
    group.dk = dk;
    group.own = own;
    group.columns.push_back({di, dj, std::ptrdiff_t(dj) * layout.nz * layout.stride + di,
                             static_cast<Real>(di * dx), static_cast<Real>(dj * dx)});
  }
  std::vector<ColumnGroup<Real>> list;
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

ColumnPlaces column_places(const Layout& layout, const Stencil& stencil) {
  ColumnPlaces places;
  const std::vector<ColumnGroup<float>> groups = column_groups<float>(layout, stencil, 0.0);
  for_column_bonds(groups, layout.nz, [&](const auto& c, int l, int m) {
    const int place = static_cast<int>(places.size());
    places[{l, c.di, c.dj, m - l}] = place;
  });
  return places;
}

namespace {

// Constants of the particles (i .. i + particles - 1, j, all layers).
template <class Real>
class ColumnBuilder {
 public:
  ColumnBuilder(const Lattice& lattice, const Stencil& stencil, BondWeights& bonds)
      : lattice_(lattice), bonds_(bonds) {
    for (int k = 0; k < lattice.nz; ++k)
      for (const Offset& o : stencil.family[k]) offsets_[{k, o.di, o.dj, o.dk}] = o;
  }

  template <int degree>
  ColumnWeights<Real> build(const LawFits<Real, degree>& law, const std::vector<ColumnGroup<Real>>& groups,
                            int i, int j, bool per_lane) {
    ColumnWeights<Real> w;
    w.groups = &groups;
    w.dx = static_cast<Real>(lattice_.dx);
    w.per_lane = per_lane;
    w.masked = per_lane || j - reach < -lattice_.mirrored_columns() || j + reach >= lattice_.ny;
    for_column_bonds(groups, lattice_.nz, [&](const auto& c, int l, int m) {
      const Offset& offset = offsets_.at({l, c.di, c.dj, m - l});
      if (per_lane) {
        add_lanes(law, w, offset, i, j, l);
      } else {
        add(law, w, offset, bonds_(i, j, l, offset));
      }
    });
    return w;
  }

 private:
  template <int degree>
  static void add(const LawFits<Real, degree>& law, ColumnWeights<Real>& w, const Offset& o,
                  const BondWeight& bond) {
    const double inverse_L2 = 1.0 / (o.length * o.length);
    w.dilatation.push_back(static_cast<Real>(inverse_L2));
    w.force.push_back(static_cast<Real>(bond.pressure * law.R[0]));
    for (int power = degree; power >= 0; --power) {
      const double scale = 0.5 * power_of(inverse_L2, power + 1);
      w.dilatation.push_back(static_cast<Real>(bond.dilatation * law.G[power] * scale));
      if (power < degree)
        w.force.push_back(static_cast<Real>(law.R[power + 1] / law.R[0] * power_of(inverse_L2, power + 1)));
      w.force.push_back(static_cast<Real>(bond.distortion * law.H[power] * scale));
    }
  }

  template <int degree>
  void add_lanes(const LawFits<Real, degree>& law, ColumnWeights<Real>& w, const Offset& o, int i, int j,
                 int l) {
    const double inverse_L2 = 1.0 / (o.length * o.length);
    const auto series = [&](std::vector<Real>& list, const Real(&c)[degree + 1]) {
      for (int power = degree; power >= 0; --power)
        list.push_back(static_cast<Real>(c[power] * power_of(inverse_L2, power)));
    };
    w.dilatation.push_back(static_cast<Real>(inverse_L2));
    series(w.dilatation, law.G);
    series(w.force, law.R);
    series(w.force, law.H);
    const std::size_t first = w.force_lanes.size();
    w.force_lanes.resize(first + 2 * block);
    for (int p = 0; p < block; ++p) {
      const BondWeight bond = bonds_(i + p, j, l, o);
      w.dilatation_lanes.push_back(static_cast<Real>(0.5 * bond.dilatation * inverse_L2));
      w.force_lanes[first + p] = static_cast<Real>(bond.pressure);
      w.force_lanes[first + block + p] = static_cast<Real>(0.5 * bond.distortion * inverse_L2);
    }
  }

  static double power_of(double x, int power) {
    double product = 1.0;
    for (; power > 0; --power) product *= x;
    return product;
  }

  const Lattice& lattice_;
  std::map<std::array<int, 4>, Offset> offsets_;
  BondWeights& bonds_;
};

}  // namespace

template <class Real>
ColumnTables<Real>::ColumnTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                                 const Material& material, const BondTableOptions& options,
                                 const BondLaw<Real>& law)
    : blocks_(layout.blocks),
      groups_(new std::vector<ColumnGroup<Real>>(column_groups<Real>(layout, stencil, lattice.dx))) {
  BondWeights bonds(lattice, stencil, material, options);
  ColumnBuilder<Real> builder(lattice, stencil, bonds);
  for (int jl = 0; jl < layout.columns; ++jl) {
    const int j = layout.j0 + jl;
    for (int b = 0; b < blocks_; ++b) {
      const int i = layout.i0 + b * block;
      const bool end = !is_interior(lattice, i);
      const Class key{std::min(j + lattice.mirrored_columns(), edge_influence),
                      std::min(lattice.ny - 1 - j, edge_influence), end ? b : -1};
      auto [entry, is_new] = weights_.try_emplace(key);
      if (is_new)
        entry->second = {builder.build(law.calm, *groups_, i, j, end),
                         builder.build(law.small, *groups_, i, j, end)};
      for (const BlockLaw which : {calm, bent}) at_[which].push_back(&entry->second[which]);
    }
  }
}

template class ColumnTables<float>;
template class ColumnTables<double>;

}  // namespace icebow
