// The bonds that a rank knows of its own particles, those to its neighbours' particles included.
#pragma once

#include <cstdint>

#include "solver/ice/sheet.h"

namespace icebow {

// A rank's own particles and a margin of `reach` around them, of a half model with their mirror images (side
// 1), numbered in the order of Lattice::id of the whole sheet. The columns below the symmetry plane are
// images of own ones and share their numbers.
class NearbyParticles {
 public:
  explicit NearbyParticles(const IceSheet& sheet)
      : sheet_(sheet),
        layout_(sheet.layout),
        whole_(whole_sheet(sheet.lattice)),
        below_(sheet.lattice.mirrored_columns()),
        columns_(layout_.columns + 2 * reach),
        width_(layout_.blocks * block + 2 * reach) {}

  int sides() const { return sheet_.lattice.copies(); }
  std::int32_t size() const { return sides() * columns_ * layout_.nz * width_; }
  std::int32_t number(int jl, int k, int il, int side = 0) const {
    if (image(jl)) return number(-1 - jl, k, il, 1 - side);
    const int along = jl + reach,
              column = side == 1 ? columns_ - 1 - along : (sides() - 1) * columns_ + along;
    return (column * layout_.nz + k) * width_ + il + reach;
  }
  // A particle's number in the whole sheet; only for particles that exist.
  std::int64_t id(std::int32_t number) const {
    const int row = number / width_, column = row / layout_.nz;
    const bool starboard = column < (sides() - 1) * columns_;
    const int j =
        layout_.j0 + (starboard ? columns_ - 1 - column : column - (sides() - 1) * columns_) - reach;
    return whole_.id(layout_.i0 + number % width_ - reach, starboard ? below_ - 1 - j : below_ + j,
                     row % layout_.nz);
  }
  // Whether the column is the mirror image of an own one.
  bool image(int jl) const { return jl < 0 && sheet_.at_symmetry_plane(); }
  bool exists(int jl, int il) const {
    const int i = layout_.i0 + il, j = layout_.j0 + jl;
    return i >= 0 && i < sheet_.lattice.nx && (j >= 0 || image(jl)) && j < sheet_.lattice.ny;
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

  // f(jl, k, il) for each own particle, in the order of Lattice::id, without the images.
  template <class F>
  void for_each_own(F f) const {
    for (int jl = 0; jl < layout_.columns; ++jl) {
      for (int k = 0; k < layout_.nz; ++k) {
        for (int il = 0; il < layout_.blocks * block && exists(jl, il); ++il) f(jl, k, il);
      }
    }
  }

  // f(lower, upper, alive) for each bond that the sheet began with and that has an own end or the image of
  // one; ends by number.
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
    const bool own_end = own(image(jl) ? -1 - jl : jl, il);
    for (const Offset& o : sheet_.stencil.half[k]) {
      const bool alive = *words++ >> lane & 1;
      const int jl2 = jl + o.dj, il2 = il + o.di;
      if ((!own_end && !own(jl2, il2)) || !exists(jl2, il2) || image(jl2)) continue;
      // The image of a bond across the plane is another one of those.
      for (int side = 0; side < (image(jl) ? 1 : sides()); ++side)
        f(number(jl, k, il, side), number(jl2, k + o.dk, il2, side), alive);
    }
  }

  const IceSheet& sheet_;
  const Layout& layout_;
  const Lattice whole_;
  const int below_, columns_, width_;
};

}  // namespace icebow
