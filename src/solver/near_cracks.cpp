#include "solver/near_cracks.h"

#include <algorithm>
#include <cstdlib>

namespace icebow {
namespace {

constexpr int span = 2 * reach + 1, offsets = span * span * span;
constexpr int columns_around = block;

int offset_number(int di, int dj, int dk) {
  return ((dj + reach) * span + (dk + reach)) * span + (di + reach);
}

// Block of the sheet and column as one number.
std::vector<double> touched_blocks(const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  const int all_blocks = sheet.lattice.blocks();
  std::vector<double> touched_ones;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int b = 0; b < layout.blocks; ++b) {
      bool any = false;
      for (int k = 0; k < layout.nz; ++k) any |= sheet.state(jl, k)[b] == touched;
      if (any) touched_ones.push_back(double(layout.j0 + jl) * all_blocks + layout.i0 / block + b);
    }
  }
  return touched_ones;
}

}  // namespace

void near_cracks(const Communicator& comm, const IceSheet& sheet,
                 const std::function<void(int jl, int k, int il)>& visit) {
  const Layout& layout = sheet.layout;
  const int all_blocks = sheet.lattice.blocks(), b0 = layout.i0 / block;
  std::vector<char> near(std::size_t(layout.columns) * layout.blocks);
  for (const double number : comm.gather_everywhere(touched_blocks(sheet))) {
    const int j = int(number) / all_blocks - layout.j0, b = int(number) % all_blocks - b0;
    for (int jl = std::max(0, j - columns_around); jl <= std::min(layout.columns - 1, j + columns_around);
         ++jl) {
      for (int beside = std::max(0, b - 1); beside <= std::min(layout.blocks - 1, b + 1); ++beside)
        near[std::size_t(jl) * layout.blocks + beside] = 1;
    }
  }
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      for (int il = 0; il < layout.blocks * block && layout.i0 + il < sheet.lattice.nx; ++il) {
        if (near[std::size_t(jl) * layout.blocks + il / block]) visit(jl, k, il);
      }
    }
  }
}

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
