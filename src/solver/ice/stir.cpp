#include "solver/ice/stir.h"

namespace icebow {
namespace {

// SplitMix64 (Steele, Lea and Flood 2014): a well mixed 64-bit number for each state.
std::uint64_t mixed(std::uint64_t state) {
  state += 0x9e3779b97f4a7c15u;
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return state ^ (state >> 31);
}

// -1 .. 1
double uniform(std::uint64_t seed, std::uint64_t number) {
  return static_cast<double>(mixed(mixed(seed) ^ number) >> 11) * 0x1p-52 - 1.0;
}

}  // namespace

void stir(IceSheet& sheet, std::uint64_t seed, double ship_speed) {
  if (seed == 0) return;
  const Layout& layout = sheet.layout;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      for (int l = 0; l < layout.blocks * block; ++l) {
        if (!sheet.mobile(jl, l)) continue;
        const std::int64_t id = sheet.lattice.id(layout.i0 + l, layout.j0 + jl, k);
        for (int c = 0; c < 3; ++c) {
          const auto number = static_cast<std::uint64_t>(3 * id + c);
          sheet.v[c][layout.row(jl, k) + l] = stirring * ship_speed * uniform(seed, number);
        }
      }
    }
  }
}

}  // namespace icebow
