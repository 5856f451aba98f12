#include "solver/kernel/families.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "solver/kernel/column_weights.h"

namespace icebow {

template <class Real>
class Families<Real>::Builder {
 public:
  Builder(const Lattice& lattice, const Layout& layout, const Stencil& stencil, const Material& material,
          const BondTableOptions& options)
      : lattice_(lattice),
        layout_(layout),
        stencil_(stencil),
        places_(column_places(layout, stencil)),
        weights_(lattice, stencil, material, options) {
    for (int k = 0; k < lattice.nz; ++k) {
      for (int s = 0; s < stencil.slots(k); ++s) {
        const Offset& o = stencil.half[k][s];
        slot_[{k, o.di, o.dj, o.dk}] = s;
      }
    }
  }

  Tables build(int jl, int k) {
    const int j = layout_.j0 + jl;
    Tables t;
    const std::vector<Offset> family = in_sheet(j, k);
    add_bonds(family, t);
    for (const Offset& o : family) t.words.push_back(word(o, jl, k));
    for (int b = 0; b < layout_.blocks; ++b) {
      const int first = layout_.i0 + b * block;
      if (is_interior(lattice_, first)) {
        if (t.interior.empty()) t.interior = weights(family, first, j, k, 1);
        continue;
      }
      t.ends[b] = weights(family, first, j, k, block);
      for (const Offset& o : family) t.whole[b].push_back(whole(o, first));
    }
    for (int b = 0; b < layout_.blocks; ++b) {
      const bool end = t.ends.count(b) > 0;
      t.end_of.push_back(end ? t.ends[b].data() : nullptr);
      t.whole_of.push_back(end ? t.whole[b].data() : nullptr);
    }
    return t;
  }

 private:
  // The family of a row's particles without what lies beyond the sides, row of neighbours by row.
  std::vector<Offset> in_sheet(int j, int k) const {
    std::vector<Offset> family;
    for (const Offset& o : stencil_.family[k])
      if (j + o.dj >= -lattice_.mirrored_columns() && j + o.dj < lattice_.ny) family.push_back(o);
    std::sort(family.begin(), family.end(), [](const Offset& a, const Offset& b) {
      return std::tie(a.dj, a.dk, a.di) < std::tie(b.dj, b.dk, b.di);
    });
    return family;
  }

  void add_bonds(const std::vector<Offset>& family, Tables& t) const {
    const auto xi = [&](int steps) { return static_cast<Real>(steps * lattice_.dx); };
    const Offset* before = nullptr;
    for (const Offset& o : family) {
      if (!before || before->dj != o.dj || before->dk != o.dk) t.rows.push_back({0, xi(o.dj), xi(o.dk)});
      ++t.rows.back().bonds;
      const std::ptrdiff_t neighbour = (std::ptrdiff_t(o.dj) * layout_.nz + o.dk) * layout_.stride + o.di;
      t.bonds.push_back({neighbour, xi(o.di), static_cast<Real>(1.0 / (o.length * o.length))});
      before = &o;
    }
  }

  FamilyWord word(const Offset& o, int jl, int k) const {
    const bool upwards = std::tie(o.dj, o.dk, o.di) > std::make_tuple(0, 0, 0);
    const int per_block = stencil_.column_slots(), di = upwards ? 0 : o.di, dj = upwards ? 0 : o.dj,
              lower_k = upwards ? k : k + o.dk;
    const int slot = upwards ? slot_.at({k, o.di, o.dj, o.dk}) : slot_.at({lower_k, -o.di, -o.dj, -o.dk});
    FamilyWord fw;
    fw.word = std::ptrdiff_t(dj) * (layout_.blocks + 2) * per_block + stencil_.first_slot[lower_k] -
              stencil_.first_slot[k] + slot;
    fw.shift = block + di;
    fw.own = jl + dj >= 0;
    fw.image = lattice_.half && layout_.j0 + jl + dj < 0;
    fw.place = places_.at({k, o.di, o.dj, o.dk});
    return fw;
  }

  std::vector<Real> weights(const std::vector<Offset>& family, int i, int j, int k, int particles) {
    std::vector<Real> table;
    for (const Offset& o : family) {
      const std::size_t first = table.size();
      table.resize(first + std::size_t(family_weights) * particles);
      for (int p = 0; p < particles; ++p) {
        const BondWeight w = weights_(i + p, j, k, o);
        table[first + half_dilatation * particles + p] = static_cast<Real>(0.5 * w.dilatation);
        table[first + pressure * particles + p] = static_cast<Real>(w.pressure);
        table[first + half_distortion * particles + p] = static_cast<Real>(0.5 * w.distortion);
      }
    }
    return table;
  }

  std::uint16_t whole(const Offset& o, int first) const {
    unsigned word = 0;
    for (int l = 0; l < block; ++l) {
      const int i = first + l, i2 = i + o.di;
      if (i >= 0 && i < lattice_.nx && i2 >= 0 && i2 < lattice_.nx) word |= 1u << l;
    }
    return static_cast<std::uint16_t>(word);
  }

  const Lattice& lattice_;
  const Layout& layout_;
  const Stencil& stencil_;
  const ColumnPlaces places_;
  BondWeights weights_;
  std::map<std::array<int, 4>, int> slot_;  // of a layer's bond upwards
};

template <class Real>
Families<Real>::Families(const Lattice& lattice, const Layout& layout, const Stencil& stencil,
                         const Material& material, const BondTableOptions& options)
    : ny_(lattice.ny), mirrored_columns_(lattice.mirrored_columns()), j0_(layout.j0), layers_(lattice.nz) {
  Builder builder(lattice, layout, stencil, material, options);
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < lattice.nz; ++k) {
      const RowClass key = row_class(jl, k);
      if (!tables_.count(key)) tables_.emplace(key, builder.build(jl, k));
      const Tables& t = tables_.at(key);
      rows_.push_back({static_cast<int>(t.rows.size()), static_cast<int>(t.bonds.size()), t.rows.data(),
                       t.bonds.data(), t.words.data(), t.interior.data(), t.end_of.data(),
                       t.whole_of.data()});
    }
  }
}

template <class Real>
typename Families<Real>::RowClass Families<Real>::row_class(int jl, int k) const {
  const int j = j0_ + jl;
  return {std::min(jl, reach), std::min(j + mirrored_columns_, edge_influence),
          std::min(ny_ - 1 - j, edge_influence), k};
}

template class Families<float>;
template class Families<double>;

}  // namespace icebow
