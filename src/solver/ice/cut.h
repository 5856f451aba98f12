// Bonds that a test takes away. One rank.
#pragma once

#include <cstdint>

#include "solver/ice/sheet.h"

namespace icebow {

// which(i, j, k, offset) of each alive bond, by its lower end, says whether it is to go. Returns how many
// went. In a half model a bond across the plane begins at an image column, j = -1 .. -reach.
template <class Which>
std::int64_t cut(IceSheet& sheet, Which which) {
  std::int64_t gone = 0;
  for (int j = sheet.first_column(); j < sheet.layout.columns; ++j) {
    for (int k = 0; k < sheet.layout.nz; ++k) {
      const std::vector<Offset>& slots = sheet.stencil.half[k];
      for (int i = 0; i < sheet.lattice.nx; ++i) {
        std::uint16_t* words = sheet.bits.row(j, k) + std::ptrdiff_t(i / block) * sheet.bits.per_block();
        const unsigned bit = 1u << i % block;
        for (std::size_t slot = 0; slot < slots.size(); ++slot) {
          if (!(words[slot] & bit) || !which(i, j, k, slots[slot])) continue;
          words[slot] = static_cast<std::uint16_t>(words[slot] & ~bit);
          ++gone;
        }
      }
    }
  }
  sheet.find_cracks();
  return gone;
}

}  // namespace icebow
