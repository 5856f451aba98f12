// Particles of two blocks' columns that are near each other; included by kernel_impl.h.
#include <algorithm>

#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"

namespace icebow {
namespace {

// Squared distance of a place from a block's box: that of no particle in it is less, but for rounding.
inline float from_box(const float (&place)[3], const NearBlock& b) {
  float sum = 0.0F;
  for (int c = 0; c < 3; ++c) {
    const float gap = std::max(0.0F, std::max(b.lower[c] - place[c], place[c] - b.upper[c]));
    sum += gap * gap;
  }
  return sum;
}

inline int near_pairs(const NearBlock& a, const NearBlock& b, int layers, float within2, bool same,
                      NearPair* out) {
  using S = Simd<float>;
  using V = S::V;
  constexpr float rounding = 1.00001F;
  const S::Mask bits = S::lane_bits();
  int found = 0;
  for (int pa = 0; pa < layers * block; ++pa) {
    const float* const at = a.places + 3 * (pa / block) * block + pa % block;
    const float from[3] = {at[0], at[block], at[2 * block]};
    if (!(from_box(from, b) < within2 * rounding)) continue;
    const V place[3] = {S::splat(from[0]), S::splat(from[1]), S::splat(from[2])};
    for (int lane0 = same ? pa / S::lanes * S::lanes : 0; lane0 < layers * block; lane0 += S::lanes) {
      const float* const row = b.places + 3 * (lane0 / block) * block + lane0 % block;
      V r2 = {};
      for (int c = 0; c < 3; ++c) {
        const V away = S::load(row + c * block) - place[c];
        r2 += away * away;
      }
      const S::Mask near = r2 < within2;
      if (!S::any(near)) continue;
      for (unsigned word = S::compress(near, bits); word; word &= word - 1) {
        const int pb = lane0 + __builtin_ctz(word);
        if (same && pb <= pa) continue;
        out[found++] = {static_cast<std::uint16_t>(pa), static_cast<std::uint16_t>(pb)};
      }
    }
  }
  return found;
}

}  // namespace
}  // namespace icebow
