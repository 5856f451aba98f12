#include "solver/ice/bond_query.h"

#include <algorithm>
#include <cstdlib>

namespace icebow {
namespace {

constexpr int span = 2 * reach + 1, offsets = span * span * span;

int offset_number(int di, int dj, int dk) {
  return ((dj + reach) * span + (dk + reach)) * span + (di + reach);
}

}  // namespace

BondQuery::BondQuery(const IceSheet& sheet)
    : sheet_(sheet), slot_(std::size_t(sheet.lattice.nz) * offsets, -1) {
  for (int k = 0; k < sheet.lattice.nz; ++k) {
    for (int s = 0; s < sheet.stencil.slots(k); ++s) {
      const Offset& o = sheet.stencil.half[k][s];
      slot_[std::size_t(k) * offsets + offset_number(o.di, o.dj, o.dk)] = s;
    }
  }
}

bool BondQuery::alive(const Place& own, const Place& other) const {
  int di = other[0] - own[0], dj = other[1] - own[1], dk = other[2] - own[2];
  if (std::max({std::abs(di), std::abs(dj), std::abs(dk)}) > reach) return false;
  // Kept at its lower end.
  const bool lower = dj > 0 || (dj == 0 && (dk > 0 || (dk == 0 && di > 0)));
  const Place& at = lower ? own : other;
  if (!lower) {
    di = -di;
    dj = -dj;
    dk = -dk;
  }
  const int slot = slot_[std::size_t(at[2]) * offsets + offset_number(di, dj, dk)];
  if (slot < 0) return false;
  const Layout& layout = sheet_.layout;
  const int il = at[0] - layout.i0, b = (il + block) / block - 1;
  const std::uint16_t* words =
      sheet_.bits.row(at[1] - layout.j0, at[2]) + std::ptrdiff_t(b) * sheet_.bits.per_block();
  return words[slot] >> (il - b * block) & 1;
}

}  // namespace icebow
