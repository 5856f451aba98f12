// Particles of two blocks' columns that are near each other; included by kernel_impl.h.
#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"

namespace icebow {
namespace {

inline int near_pairs(const float* a, const float* b, int layers, float within2, bool same, NearPair* out) {
  using S = Simd<float>;
  using V = S::V;
  const S::Mask bits = S::lane_bits();
  int found = 0;
  for (int pa = 0; pa < layers * block; ++pa) {
    const float* const at = a + 3 * (pa / block) * block + pa % block;
    const V place[3] = {S::splat(at[0]), S::splat(at[block]), S::splat(at[2 * block])};
    for (int lane0 = same ? pa / S::lanes * S::lanes : 0; lane0 < layers * block; lane0 += S::lanes) {
      const float* const row = b + 3 * (lane0 / block) * block + lane0 % block;
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
