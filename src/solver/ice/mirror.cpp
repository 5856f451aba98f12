#include "solver/ice/mirror.h"

#include <algorithm>

namespace icebow {
namespace {

template <class Real>
void mirror(Field& field, const Layout& layout, Real sign) {
  for (int jl = 0; jl < reach; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const Real* const own = field.data<Real>() + layout.row(jl, k) - ghost_blocks * block;
      Real* const image = field.data<Real>() + layout.row(-1 - jl, k) - ghost_blocks * block;
      std::transform(own, own + layout.stride, image, [sign](Real value) { return sign * value; });
    }
  }
}

void mirror(const IceSheet& sheet, Field& field, int sign) {
  if (sheet.precision == Precision::fp64) {
    mirror<double>(field, sheet.layout, sign);
  } else {
    mirror<float>(field, sheet.layout, static_cast<float>(sign));
  }
}

struct BondAt {
  int jl, k, i;  // of the lower end; i counts from the first own particle
  Offset offset;
};

BondAt image_of(const BondAt& bond) {
  const Offset& o = bond.offset;
  BondAt image{-1 - (bond.jl + o.dj), bond.k + o.dk, bond.i + o.di, o};
  image.offset.di = -o.di;
  image.offset.dk = -o.dk;
  return image;
}

int slot_of(const Stencil& stencil, const BondAt& bond) {
  const auto same = [&](const Offset& o) {
    return o.di == bond.offset.di && o.dj == bond.offset.dj && o.dk == bond.offset.dk;
  };
  const auto& slots = stencil.half[bond.k];
  return static_cast<int>(std::find_if(slots.begin(), slots.end(), same) - slots.begin());
}

// Of a row and slot: the word of the block that holds particle i, which may be a ghost.
std::uint16_t& word_at(IceSheet& sheet, const BondAt& bond, int slot) {
  const int b = bond.i < 0 ? -1 : bond.i / block;
  return sheet.bits.row(bond.jl, bond.k)[std::ptrdiff_t(b) * sheet.bits.per_block() + slot];
}

void copy_image(IceSheet& sheet, BondAt bond, int slot, int first, int last) {
  for (bond.i = first; bond.i < last; ++bond.i) {
    const BondAt image = image_of(bond);
    const unsigned alive =
        word_at(sheet, image, slot_of(sheet.stencil, image)) >> (image.i & (block - 1)) & 1u;
    const unsigned bit = 1u << (bond.i & (block - 1));
    std::uint16_t& word = word_at(sheet, bond, slot);
    word = static_cast<std::uint16_t>(alive ? word | bit : word & ~bit);
  }
}

}  // namespace

void mirror_bonds_beyond_ends(IceSheet& sheet) {
  const bool west = sheet.partition.west >= 0, east = sheet.partition.east >= 0;
  if (!sheet.at_symmetry_plane() || !(west || east)) return;
  const int n = sheet.layout.blocks * block;
  for (int jl = -reach; jl < 0; ++jl) {
    for (int k = 0; k < sheet.layout.nz; ++k) {
      for (int s = 0; s < sheet.stencil.slots(k); ++s) {
        const Offset& o = sheet.stencil.half[k][s];
        if (jl + o.dj < 0) continue;
        if (o.di > 0 && east) copy_image(sheet, {jl, k, 0, o}, s, n - o.di, n);
        if (o.di < 0 && west) copy_image(sheet, {jl, k, 0, o}, s, 0, -o.di);
      }
    }
  }
}

void mirror_displacements(IceSheet& sheet) {
  if (!sheet.at_symmetry_plane()) return;
  for (int c = 0; c < 3; ++c) mirror(sheet, sheet.u[c], c == 1 ? -1 : 1);
  mirror(sheet, sheet.extra_strength, 1);
}

void mirror_dilatations(IceSheet& sheet) {
  if (sheet.at_symmetry_plane()) mirror(sheet, sheet.theta, 1);
}

}  // namespace icebow
