#include "solver/ice/near_cracks.h"

#include <algorithm>

namespace icebow {
namespace {

constexpr int columns_around = block;

bool is_cracked(const IceSheet& sheet, int jl, int b) {
  bool any = false;
  for (int k = 0; k < sheet.layout.nz; ++k) any |= (sheet.state(jl, k)[b] & cracked) != 0;
  return any;
}

// Block of the sheet and column as one number.
std::vector<double> cracked_blocks(const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  const int all_blocks = sheet.lattice.blocks();
  std::vector<double> cracked_ones;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int b = 0; b < layout.blocks; ++b) {
      if (is_cracked(sheet, jl, b))
        cracked_ones.push_back(double(layout.j0 + jl) * all_blocks + layout.i0 / block + b);
    }
  }
  return cracked_ones;
}

}  // namespace

std::vector<Nearness> find_near_cracks(const Communicator& comm, const IceSheet& sheet) {
  const Layout& layout = sheet.layout;
  const int all_blocks = sheet.lattice.blocks(), b0 = layout.i0 / block;
  std::vector<Nearness> near(std::size_t(layout.columns) * layout.blocks, far_from_cracks);
  for (const double number : comm.gather_everywhere(cracked_blocks(sheet))) {
    const int j = int(number) / all_blocks - layout.j0, b = int(number) % all_blocks - b0;
    for (int jl = std::max(0, j - columns_around); jl <= std::min(layout.columns - 1, j + columns_around);
         ++jl) {
      for (int beside = std::max(0, b - 1); beside <= std::min(layout.blocks - 1, b + 1); ++beside) {
        Nearness& now = near[std::size_t(jl) * layout.blocks + beside];
        now = std::max(now, jl == j && beside == b ? at_cracks : near_cracks);
      }
    }
  }
  return near;
}

}  // namespace icebow
