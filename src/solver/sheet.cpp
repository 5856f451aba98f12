#include "solver/sheet.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace icebow {
namespace {

// Columns held at a fixed edge: as many as a bond can reach, so that the free ice never feels the edge's
// surface.
constexpr int held_columns = reach;

}  // namespace

Field::Field(std::size_t n, int stagger) {
  constexpr std::size_t line = 64, lines_apart = 5;
  const std::size_t offset = stagger * lines_apart * line;
  const std::size_t bytes = offset + (n * sizeof(float) + line - 1) / line * line;
  memory_.reset(static_cast<float*>(std::aligned_alloc(line, bytes)));
  if (!memory_) throw std::bad_alloc();
  std::memset(memory_.get(), 0, bytes);
  data_ = memory_.get() + offset / sizeof(float);
}

void Field::Free::operator()(float* p) const {
  std::free(p);
}

BondBits::BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil)
    : blocks_(layout.blocks),
      columns_(layout.columns),
      per_block_(stencil.column_slots()),
      first_slot_(stencil.first_slot),
      words_(std::size_t(layout.columns + reach) * (layout.blocks + 2) * stencil.column_slots()) {
  for (int jl = -reach; jl < layout.columns; ++jl) {
    for (int b = -1; b <= layout.blocks; ++b) {
      for (int k = 0; k < lattice.nz; ++k) {
        std::uint16_t* words = &words_[index(jl, b, k)];
        for (int s = 0; s < stencil.slots(k); ++s) {
          const Offset& o = stencil.half[k][s];
          const int j = layout.j0 + jl;
          if (j < 0 || j + o.dj >= lattice.ny) continue;
          for (int l = 0; l < block; ++l) {
            const int i = layout.i0 + b * block + l, i2 = i + o.di;
            if (i >= 0 && i < lattice.nx && i2 >= 0 && i2 < lattice.nx)
              words[s] |= static_cast<std::uint16_t>(1u << l);
          }
        }
      }
    }
  }
}

std::int64_t BondBits::count() const {
  std::int64_t n = 0;
  for (int jl = 0; jl < columns_; ++jl) {
    const std::uint16_t* words = row(jl, 0);
    for (int w = 0; w < blocks_ * per_block_; ++w) n += __builtin_popcount(words[w]);
  }
  return n;
}

IceSheet::IceSheet(const Scenario& s, const Lattice& l, const Partition& p, const Material& material,
                   const Kernels& kernels_used)
    : lattice(l),
      partition(p),
      layout(l, p),
      stencil(make_stencil(l.nz, l.dx, material.delta)),
      kernel(kernels_used),
      u{Field(layout.size, 0), Field(layout.size, 1), Field(layout.size, 2)},
      v{Field(layout.size, 3), Field(layout.size, 4), Field(layout.size, 5)},
      residual{Field(layout.size, 6), Field(layout.size, 7), Field(layout.size, 8)},
      acceleration{Field(layout.size, 9), Field(layout.size, 10), Field(layout.size, 11)},
      theta(layout.size, 12),
      bits(l, layout, stencil),
      fixed_(s.sheet.fixed),
      tables_(l, layout, stencil, material, {s.numerics.surface_correction, s.ice.rho}),
      touched_(std::size_t(layout.columns + reach) * l.nz * (layout.blocks + 2)),
      near_hull_(std::size_t(layout.columns) * l.nz * layout.blocks) {
  for (int local = 0; local < layout.blocks * block; ++local) {
    const int i = layout.i0 + local;
    const bool far_end = fixed_ == FixedEdges::sides_and_far && i >= l.nx - held_columns;
    reference_x_.push_back(static_cast<float>(l.x(i)));
    mobile_x_.push_back(i < l.nx && !far_end ? 1.0f : 0.0f);
    nothing_mobile_.push_back(0.0f);
  }
  // Near the far side some bonds to higher columns are missing: those blocks look at the bits from the start.
  for (int jl = -reach; jl < layout.columns; ++jl) {
    if (layout.j0 + jl < l.ny - reach) continue;
    for (int k = 0; k < l.nz; ++k) std::memset(touched(jl, k) - 1, 1, layout.blocks + 2);
  }
}

bool IceSheet::held(int i, int j) const {
  if (fixed_ == FixedEdges::none) return false;
  if (fixed_ == FixedEdges::sides_and_far && i >= lattice.nx - held_columns) return true;
  return j < held_columns || j >= lattice.ny - held_columns;
}

RowFields IceSheet::fields(int jl, int k) {
  const std::size_t r = layout.row(jl, k);
  return {{u[0].data() + r, u[1].data() + r, u[2].data() + r},
          {acceleration[0].data() + r, acceleration[1].data() + r, acceleration[2].data() + r},
          theta.data() + r,
          bits.row(jl, k),
          bits.per_block(),
          touched(jl, k),
          partition.west >= 0 ? -1 : 0,
          layout.blocks + (partition.east >= 0 ? 1 : 0)};
}

void IceSheet::drift(const DriftSettings& settings) {
  for (int jl = 0; jl < layout.columns; ++jl) {
    const bool moves = !held(0, layout.j0 + jl);
    for (int k = 0; k < layout.nz; ++k) {
      const std::size_t r = layout.row(jl, k);
      kernel.drift({{u[0].data() + r, u[1].data() + r, u[2].data() + r},
                    {v[0].data() + r, v[1].data() + r, v[2].data() + r},
                    {residual[0].data() + r, residual[1].data() + r, residual[2].data() + r},
                    {acceleration[0].data() + r, acceleration[1].data() + r, acceleration[2].data() + r},
                    theta.data() + r,
                    reference_x_.data(),
                    moves ? mobile_x_.data() : nothing_mobile_.data(),
                    static_cast<float>(lattice.y(layout.j0 + jl)),
                    static_cast<float>(lattice.z(k)),
                    &near_hull_[(std::size_t(jl) * layout.nz + k) * layout.blocks],
                    layout.blocks},
                   settings);
    }
  }
}

std::int64_t IceSheet::dilatation(const BondLaw& law) {
  std::int64_t broken = 0;
  for (int jl = first_row(); jl < layout.columns; ++jl) {
    select_column(jl);
    const int in_column =
        kernel.dilatation(column_fields_.data(), column_tables_.data(), layout.nz, law, layout.blocks);
    if (jl >= 0) broken += in_column;
  }
  return broken;
}

void IceSheet::force(const BondLaw& law) {
  for (int jl = first_row(); jl < layout.columns; ++jl) {
    select_column(jl);
    kernel.force(column_fields_.data(), column_tables_.data(), layout.nz, law);
  }
}

void IceSheet::select_column(int jl) {
  column_fields_.clear();
  column_tables_.clear();
  for (int k = 0; k < layout.nz; ++k) {
    column_fields_.push_back(fields(jl, k));
    column_tables_.push_back(tables_.row(jl, k));
  }
}

}  // namespace icebow
