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

Field::Field(std::size_t n) {
  constexpr std::size_t line = 64;
  const std::size_t bytes = (n * sizeof(float) + line - 1) / line * line;
  data_.reset(static_cast<float*>(std::aligned_alloc(line, bytes)));
  if (!data_) throw std::bad_alloc();
  std::memset(data_.get(), 0, bytes);
}

void Field::Free::operator()(float* p) const {
  std::free(p);
}

BondBits::BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil)
    : blocks_(layout.blocks),
      per_block_(stencil.column_slots()),
      first_slot_(stencil.first_slot),
      words_(std::size_t(layout.columns) * layout.blocks * stencil.column_slots()) {
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int b = 0; b < layout.blocks; ++b) {
      for (int k = 0; k < lattice.nz; ++k) {
        std::uint16_t* words = &words_[index(jl, b, k)];
        for (int s = 0; s < stencil.slots(k); ++s) {
          const Offset& o = stencil.layer[k][s];
          const int j2 = layout.j0 + jl + o.dj;
          if (j2 < 0 || j2 >= lattice.ny) continue;
          for (int l = 0; l < block; ++l) {
            const int i = layout.i0 + b * block + l, i2 = i + o.di;
            if (i < lattice.nx && i2 >= 0 && i2 < lattice.nx) words[s] |= static_cast<std::uint16_t>(1u << l);
          }
        }
      }
    }
  }
}

std::int64_t BondBits::count() const {
  std::int64_t n = 0;
  for (std::uint16_t w : words_) n += __builtin_popcount(w);
  return n;
}

IceSheet::IceSheet(const Scenario& s, const Lattice& l, const Partition& p, const Material& material)
    : lattice(l),
      partition(p),
      layout(l, p),
      stencil(make_stencil(l.nz, l.dx, material.delta)),
      u{Field(layout.size), Field(layout.size), Field(layout.size)},
      v{Field(layout.size), Field(layout.size), Field(layout.size)},
      residual{Field(layout.size), Field(layout.size), Field(layout.size)},
      theta(layout.size),
      bits(l, layout, stencil),
      kernel_(&kernels()),
      fixed_(s.sheet.fixed),
      tables_(l, layout, stencil, material, {s.numerics.surface_correction, s.ice.rho}),
      touched_(std::size_t(layout.columns) * l.nz * layout.blocks),
      near_hull_(touched_.size()) {
  for (int local = 0; local < layout.blocks * block; ++local) {
    const int i = layout.i0 + local;
    const bool far_end = fixed_ == FixedEdges::sides_and_far && i >= l.nx - held_columns;
    reference_x_.push_back(static_cast<float>(l.x(i)));
    mobile_x_.push_back(i < l.nx && !far_end ? 1.0f : 0.0f);
  }
  // Near the port and starboard edges families are incomplete: their blocks look at the bits from the start.
  for (int jl = 0; jl < layout.columns; ++jl) {
    const int j = layout.j0 + jl;
    if (j >= reach && j < l.ny - reach) continue;
    const std::size_t first = std::size_t(jl) * l.nz * layout.blocks;
    std::memset(&touched_[first], 1, std::size_t(l.nz) * layout.blocks);
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
          {v[0].data() + r, v[1].data() + r, v[2].data() + r},
          theta.data() + r,
          bits.row(jl, k),
          bits.per_block(),
          &touched_[(std::size_t(jl) * layout.nz + k) * layout.blocks],
          layout.blocks};
}

void IceSheet::drift(const DriftSettings& settings) {
  for (int jl = 0; jl < layout.columns; ++jl) {
    if (held(0, layout.j0 + jl)) continue;
    for (int k = 0; k < layout.nz; ++k) {
      const std::size_t r = layout.row(jl, k);
      kernel_->drift({{u[0].data() + r, u[1].data() + r, u[2].data() + r},
                    {v[0].data() + r, v[1].data() + r, v[2].data() + r},
                    {residual[0].data() + r, residual[1].data() + r, residual[2].data() + r},
                    reference_x_.data(),
                    mobile_x_.data(),
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
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) broken += kernel_->dilatation(fields(jl, k), tables_.row(jl, k), law);
  }
  return broken;
}

void IceSheet::force(const BondLaw& law, double dt) {
  for (int jl = 0; jl < layout.columns; ++jl) {
    if (held(0, layout.j0 + jl)) continue;
    for (int k = 0; k < layout.nz; ++k) {
      kernel_->force(fields(jl, k), tables_.row(jl, k), law, static_cast<float>(dt));
    }
  }
}

}  // namespace icebow
