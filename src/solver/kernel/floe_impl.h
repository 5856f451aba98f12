// Forces between particles of different pieces; included by kernel_impl.h.
#include <cstring>

#include "solver/kernel/floe_forces.h"
#include "solver/kernel/kernel_vector.h"

namespace icebow {
namespace {

// Rounded halves to even, of less than 2^51: the sum's last bit is a one.
inline Simd<double>::Mask nearest_whole(Simd<double>::V x) {
  constexpr double shift = 6755399441055744.0;  // 3 * 2^51
  const Simd<double>::V shifted = x + shift;
  return (Simd<double>::Mask)shifted - (Simd<double>::Mask)Simd<double>::splat(shift);
}

// `per_force`: quanta of a newton. What is no number counts as no force.
inline void floe_forces(const FloeContactLaw& law, const FloeTouches& t, double per_force) {
  using S = Simd<double>;
  using V = S::V;
  for (int n = 0; n < t.pairs; n += S::lanes) {
    V away[3], velocity[3], r2 = {}, approach = {};
    for (int c = 0; c < 3; ++c) {
      away[c] = S::load(t.away[c] + n);
      velocity[c] = S::load(t.velocity[c] + n);
      r2 += away[c] * away[c];
      approach += velocity[c] * away[c];
    }
    const V r = root(r2), per_r = 1.0 / r;
    approach *= per_r;
    const V pressed = S::min(S::max(law.stiffness * (law.distance - r) - law.damping * approach, V{}),
                             S::splat(law.strongest));
    V speed2 = {};
    for (int c = 0; c < 3; ++c) {
      away[c] *= per_r;
      velocity[c] -= approach * away[c];
      speed2 += velocity[c] * velocity[c];
    }
    const V slowing = S::min(law.friction * pressed / root(speed2), S::splat(law.creep));
    const S::Mask acts = pressed > 0.0;
    for (int c = 0; c < 3; ++c) {
      const V force = S::keep(slowing * velocity[c] - pressed * away[c], acts);
      const S::Mask quanta = nearest_whole(force * per_force);
      std::memcpy(t.force[c] + n, &quanta, sizeof quanta);
    }
  }
}

}  // namespace
}  // namespace icebow
