// The bonds that a rank knows of its own particles, those to its neighbours' particles included.
#pragma once

#include <cstdint>

#include "solver/sheet.h"

namespace icebow {

// A rank's own particles and a margin of `reach` around them, numbered in the order of Lattice::id.
class NearbyParticles {
 public:
  explicit NearbyParticles(const IceSheet& sheet)
      : sheet_(sheet), layout_(sheet.layout), width_(layout_.blocks * block + 2 * reach) {}

  std::int32_t size() const { return (layout_.columns + 2 * reach) * layout_.nz * width_; }
  std::int32_t number(int jl, int k, int il) const {
    return ((jl + reach) * layout_.nz + k) * width_ + il + reach;
  }
  // Of the whole sheet; for numbers of particles that exist.
  std::int64_t id(std::int32_t number) const {
    const int row = number / width_;
    return sheet_.lattice.id(layout_.i0 + number % width_ - reach, layout_.j0 + row / layout_.nz - reach,
                             row % layout_.nz);
  }
  bool exists(int jl, int il) const {
    const int i = layout_.i0 + il, j = layout_.j0 + jl;
    return i >= 0 && i < sheet_.lattice.nx && j >= 0 && j < sheet_.lattice.ny;
  }
  bool own(int jl, int il) const {
    return jl >= 0 && jl < layout_.columns && il >= 0 && il < layout_.blocks * block;
  }
  // Own, and within the reach of another rank's particle.
  bool shared(int jl, int il) const {
    const Partition& p = sheet_.partition;
    return (p.south >= 0 && jl < reach) || (p.north >= 0 && jl >= layout_.columns - reach) ||
           (p.west >= 0 && il < reach) || (p.east >= 0 && il >= layout_.blocks * block - reach);
  }

  // f(jl, k, il) for each own particle, in the order of Lattice::id.
  template <class F>
  void for_each_own(F f) const {
    for (int jl = 0; jl < layout_.columns; ++jl) {
      for (int k = 0; k < layout_.nz; ++k) {
        for (int il = 0; il < layout_.blocks * block && exists(jl, il); ++il) f(jl, k, il);
      }
    }
  }

  // f(lower, upper, alive) for each bond that the sheet began with and that has an own end; ends by number.
  template <class F>
  void for_each_bond(F f) const {
    for (int jl = -reach; jl < layout_.columns; ++jl) {
      for (int k = 0; k < layout_.nz; ++k) {
        for (int il = -reach; il < layout_.blocks * block + reach; ++il) {
          if (exists(jl, il)) bonds_of(jl, k, il, f);
        }
      }
    }
  }

 private:
  template <class F>
  void bonds_of(int jl, int k, int il, F f) const {
    const int b = (il + block) / block - 1, lane = il - b * block;
    const std::uint16_t* words = sheet_.bits.row(jl, k) + std::ptrdiff_t(b) * sheet_.bits.per_block();
    const bool own_end = own(jl, il);
    for (const Offset& o : sheet_.stencil.half[k]) {
      const bool alive = *words++ >> lane & 1;
      const int jl2 = jl + o.dj, il2 = il + o.di;
      if ((own_end || own(jl2, il2)) && exists(jl2, il2))
        f(number(jl, k, il), number(jl2, k + o.dk, il2), alive);
    }
  }

  const IceSheet& sheet_;
  const Layout& layout_;
  int width_;
};

}  // namespace icebow
