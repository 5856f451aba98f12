// Included by kernel_<name>.cpp with ICEBOW_VECTOR_BYTES defined: see kernel.h.
#include <algorithm>

#include "solver/kernel/kernel.h"
#include "solver/kernel/kernel_vector.h"
#include "solver/kernel/linear_impl.h"

namespace icebow {
namespace {

// Vectors whose theta is summed together: they share the loads of a slot's constants.
template <class Real>
constexpr int at_once = block / Simd<Real>::lanes < 2 ? 1 : 2;

template <bool per_lane>
constexpr int slot_size = constants_per_slot*(per_lane ? block : 1);

// One constant of a slot for N vectors, loaded once: a compiler must think that a store may change it.
template <class Real, bool per_lane, int N>
class Constants {
 public:
  Constants(const Real* slot, int which) {
    for (int v = 0; v < (per_lane ? N : 1); ++v)
      c_[v] = Simd<Real>::template constant<per_lane>(slot, which, v);
  }
  typename Simd<Real>::V operator[](int v) const { return c_[per_lane ? v : 0]; }

 private:
  typename Simd<Real>::V c_[per_lane ? N : 1];
};

template <class Real, int n>
inline typename Simd<Real>::V series(const Real (&c)[n], typename Simd<Real>::V e) {
  typename Simd<Real>::V p = Simd<Real>::splat(c[n - 1]);
  for (int power = n - 2; power >= 0; --power) p = p * e + c[power];
  return p;
}

// theta of N vectors of a calm block; returns the state of the most strained of them. One that may have left
// intact's range within a step is called touched right away: its bonds may want to break in the next step.
template <class Real, bool per_lane, int N>
BlockState calm_theta(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law,
                      std::ptrdiff_t x, const Real* slot) {
  using S = Simd<Real>;
  using V = typename S::V;
  const Real *const u0 = f.u[0] + x, *const u1 = f.u[1] + x, *const u2 = f.u[2] + x;
  Real* const theta = f.theta + x;
  V c0[N], c1[N], c2[N], own[N], high[N], low[N];
  for (int v = 0; v < N; ++v) {
    c0[v] = S::load(u0 + v * S::lanes);
    c1[v] = S::load(u1 + v * S::lanes);
    c2[v] = S::load(u2 + v * S::lanes);
    own[v] = high[v] = low[v] = V{};
  }
  const std::ptrdiff_t* const end = t.neighbour + t.n_slots;
  for (const std::ptrdiff_t* nb = t.neighbour; nb != end; ++nb, slot += slot_size<per_lane>) {
    const std::ptrdiff_t n = *nb;
    const Constants<Real, per_lane, N> xi0(slot, xi2_x), xi1(slot, xi2_y), xi2(slot, xi2_z),
        weight(slot, calm_dilatation), iL2(slot, inverse_L2);
    V term[N];
    for (int v = 0; v < N; ++v) {
      const std::ptrdiff_t o = n + v * S::lanes;
      // q = (-eta) . (-eta - 2 xi)
      const V m0 = c0[v] - S::load(u0 + o), m1 = c1[v] - S::load(u1 + o), m2 = c2[v] - S::load(u2 + o);
      V q = m0 * (m0 - xi0[v]);
      q += m1 * (m1 - xi1[v]);
      q += m2 * (m2 - xi2[v]);
      term[v] = q * weight[v];
      if constexpr (LawDegrees<Real>::calm > 0) term[v] *= series<Real>(law.calm.G, q * iL2[v]);
    }
    for (int v = 0; v < N; ++v) {
      own[v] += term[v];
      high[v] = S::max(high[v], term[v]);
      low[v] = S::min(low[v], term[v]);
      Real* const there = theta + n + v * S::lanes;
      S::store(there, S::load(there) + term[v]);
    }
  }
  const Real calm_limit = law.e_calm * t.theta_per_strain, small_limit = law.e_small * t.theta_per_strain;
  typename S::Mask strained = {}, far = {};
  for (int v = 0; v < N; ++v) {
    S::store(theta + v * S::lanes, S::load(theta + v * S::lanes) + own[v]);
    const V size = S::max(high[v], -low[v]);
    strained |= size > calm_limit;
    far |= size > small_limit;
  }
  if (!S::any(strained)) return calm;
  return S::any(far) ? touched : intact;
}

// One vector: two would need more registers than AVX2 has.
template <class Real, bool per_lane>
void calm_force(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law,
                std::ptrdiff_t x, const Real* slot) {
  using S = Simd<Real>;
  using V = typename S::V;
  const auto constant = [&](int which) { return S::template constant<per_lane>(slot, which); };
  const Real *const u0 = f.u[0] + x, *const u1 = f.u[1] + x, *const u2 = f.u[2] + x;
  const Real* const theta = f.theta + x;
  Real *const a0 = f.acceleration[0] + x, *const a1 = f.acceleration[1] + x,
              *const a2 = f.acceleration[2] + x;
  const V c0 = S::load(u0), c1 = S::load(u1), c2 = S::load(u2), own_theta = S::load(theta);
  V own0 = {}, own1 = {}, own2 = {};
  const std::ptrdiff_t* const end = t.neighbour + t.n_slots;
  for (const std::ptrdiff_t* nb = t.neighbour; nb != end; ++nb, slot += slot_size<per_lane>) {
    const std::ptrdiff_t o = *nb;
    const V xi0 = constant(xi_x), xi1 = constant(xi_y), xi2 = constant(xi_z);
    // Minus eta, minus y; q = (-eta) . (-y - xi)
    const V m0 = c0 - S::load(u0 + o), m1 = c1 - S::load(u1 + o), m2 = c2 - S::load(u2 + o);
    const V y0 = m0 - xi0, y1 = m1 - xi1, y2 = m2 - xi2;
    V q = m0 * (y0 - xi0);
    q += m1 * (y1 - xi1);
    q += m2 * (y2 - xi2);
    V stretch = q * constant(calm_distortion),
      pressure = (own_theta + S::load(theta + o)) * constant(pressure_weight);
    if constexpr (LawDegrees<Real>::calm > 0) {
      const V e = q * constant(inverse_L2);
      stretch *= series<Real>(law.calm.H, e);
      pressure *= series<Real>(law.calm.R, e);
    }
    const V scale = stretch + pressure;
    own0 -= scale * y0;
    own1 -= scale * y1;
    own2 -= scale * y2;
    S::store(a0 + o, scale * y0 + S::load(a0 + o));
    S::store(a1 + o, scale * y1 + S::load(a1 + o));
    S::store(a2 + o, scale * y2 + S::load(a2 + o));
  }
  S::store(a0, S::load(a0) + own0);
  S::store(a1, S::load(a1) + own1);
  S::store(a2, S::load(a2) + own2);
}

// A bond seen from its higher end: minus y, and e = q / L^2.
template <class Real>
struct Bond {
  typename Simd<Real>::V minus_y[3];
  typename Simd<Real>::V e;
};

template <class Real, bool per_lane>
inline Bond<Real> bond(const Real* const* u, std::ptrdiff_t n, const typename Simd<Real>::V* centre,
                       const Real* slot) {
  using S = Simd<Real>;
  Bond<Real> b;
  typename S::V q = {};
  for (int c = 0; c < 3; ++c) {
    const typename S::V xi = S::template constant<per_lane>(slot, xi_x + c);
    const typename S::V minus_eta = centre[c] - S::load(u[c] + n);
    b.minus_y[c] = minus_eta - xi;
    q += minus_eta * (b.minus_y[c] - xi);
  }
  b.e = q * S::template constant<per_lane>(slot, inverse_L2);
  return b;
}

// Bits of `lanes` particles within a 16-bit word.
template <int lanes>
inline unsigned part_of(std::uint16_t word, int lane0) {
  return (word >> lane0) & ((1u << lanes) - 1u);
}

// The fits of a block, and where they are evaluated.
template <bool whole, class Real>
inline const auto& fits_of(const BondLaw<Real>& law) {
  if constexpr (whole) {
    return law.small;
  } else {
    return law.wide;
  }
}
template <bool whole, class Real>
inline typename Simd<Real>::V fit_argument(typename Simd<Real>::V e, const BondLaw<Real>& law) {
  if constexpr (whole) return e;
  return Simd<Real>::min(Simd<Real>::max(e, Simd<Real>::splat(law.e_min)), Simd<Real>::splat(law.e_max));
}

// theta of the bonds of a block that is not calm. A `whole` one (intact) has all its bonds and does not look
// at the bits; where a bond leaves the range of the short fits or wants to break, the block becomes touched,
// and the bond breaks in the next step if it still wants to. Of ice that breaks by
// stress, which is touched long before it breaks, a touched block whose bonds are all there and have
// slackened becomes intact; not near the ends of the sheet, where it has fewer bonds to be told by.
template <class Real, bool whole, bool per_lane>
int block_theta(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law, int b,
                const Real* constants) {
  using S = Simd<Real>;
  using V = typename S::V;
  using Mask = typename S::Mask;
  const Mask bits = S::lane_bits();
  const typename S::template Polynomial<LawDegrees<Real>::wide + 1> wide_G(law.wide.G);
  const typename S::template Polynomial<LawDegrees<Real>::small + 1> small_G(law.small.G);
  std::uint16_t* const words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
  V e_max = {}, e_min = {};
  int broken = 0;
  std::uint16_t alive_everywhere = 0xffff;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])};
    Real* const theta = f.theta + x;
    const V strength = S::load(f.extra_strength + x) + S::splat(law.e_break);
    const Real* slot = constants + (per_lane ? lane0 : 0);
    V own = {};
    for (int s = 0; s < t.n_slots; ++s, slot += slot_size<per_lane>) {
      unsigned alive = 0;
      if constexpr (!whole) {
        alive = part_of<S::lanes>(words[s], lane0);
        if (per_lane || slot[dilatation_weight] != 0) alive_everywhere &= words[s];
        if (!alive) continue;
      } else if constexpr (!per_lane) {
        if (slot[dilatation_weight] == 0) continue;  // beyond the far side
      }
      const std::ptrdiff_t n = t.neighbour[s];
      const Bond<Real> bd = bond<Real, per_lane>(u, n, centre, slot);
      const V weight = S::template constant<per_lane>(slot, dilatation_weight);
      V term;
      if constexpr (whole) {
        const V e = per_lane ? S::keep(bd.e, weight != V{}) : bd.e;
        term = weight * (e * small_G(e));
        e_max = S::max(e_max, e);
        e_min = S::min(e_min, e);
      } else {
        term = weight * (bd.e * wide_G(fit_argument<false, Real>(bd.e, law)));
        const Mask mask = S::expand(alive, bits);
        const V e_alive = S::keep(bd.e, mask);
        e_max = S::max(e_max, e_alive);
        e_min = S::min(e_min, e_alive);
        const Mask breaks = mask & (bd.e > strength + S::load(f.extra_strength + x + n));
        if (__builtin_expect(S::any(breaks), 0)) {
          const unsigned gone = S::compress(breaks, bits);
          words[s] = static_cast<std::uint16_t>(words[s] & ~(gone << lane0));
          broken += __builtin_popcount(gone);
        }
        term = S::keep(term, mask & ~breaks);
      }
      own += term;
      S::store(theta + n, S::load(theta + n) + term);
    }
    S::store(theta, S::load(theta) + own);
  }
  if constexpr (whole) {
    if (S::any((e_max > law.e_small) | (e_min < -law.e_small))) {
      f.state[b] = touched;
    } else if (!S::any((e_max > law.e_calm / 2) | (e_min < -law.e_calm / 2))) {
      f.state[b] = calm;
    }
  } else if (!per_lane && alive_everywhere == 0xffff && law.stress_per_stretch > 0) {
    if (!S::any((e_max > law.e_small / 2) | (e_min < -law.e_small / 2))) f.state[b] = intact;
  }
  return broken;
}

template <class Real, bool per_lane>
int theta_by_state(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law, int b,
                   const Real* constants) {
  if (f.state[b] == touched) return block_theta<Real, false, per_lane>(f, t, law, b, constants);
  if (f.state[b] == intact) return block_theta<Real, true, per_lane>(f, t, law, b, constants);
  constexpr int N = at_once<Real>, step = N * Simd<Real>::lanes;
  BlockState state = calm;
  for (int lane0 = 0; lane0 < block; lane0 += step) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    state = std::max(state, calm_theta<Real, per_lane, N>(f, t, law, x, constants + (per_lane ? lane0 : 0)));
  }
  f.state[b] = state;
  return 0;
}

template <class Real>
int dilatation(const RowFields<Real>* rows, const RowTables<Real>* tables, int nz, const BondLaw<Real>& law,
               int owned_blocks) {
  int broken = 0;
  for (int b = rows[0].first_block; b < rows[0].last_block; ++b) {
    if (rows[0].skip[b]) continue;
    int in_block = 0;
    for (int k = 0; k < nz; ++k) {
      const RowTables<Real>& t = tables[k];
      in_block += t.ends[b] ? theta_by_state<Real, true>(rows[k], t, law, b, t.ends[b])
                            : theta_by_state<Real, false>(rows[k], t, law, b, t.interior);
    }
    if (b >= 0 && b < owned_blocks) broken += in_block;
  }
  return broken;
}

template <class Real, bool whole, bool per_lane, bool by_stress>
int block_force(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law, int b,
                const Real* constants) {
  using S = Simd<Real>;
  using V = typename S::V;
  constexpr int n = (whole ? LawDegrees<Real>::small : LawDegrees<Real>::wide) + 1;
  const typename S::Mask bits = S::lane_bits();
  const typename S::template Polynomial<n> R(fits_of<whole>(law).R), H(fits_of<whole>(law).H);
  const typename S::template Polynomial<LawDegrees<Real>::wide + 1> G(law.wide.G);
  std::uint16_t* const words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
  int broken = 0;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const Real* const theta = f.theta + x;
    const V strength = S::load(f.extra_strength + x) + S::splat(1);
    Real* const a[3] = {f.acceleration[0] + x, f.acceleration[1] + x, f.acceleration[2] + x};
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])};
    const V own_theta = S::load(theta);
    const Real* slot = constants + (per_lane ? lane0 : 0);
    V own[3] = {};
    for (int s = 0; s < t.n_slots; ++s, slot += slot_size<per_lane>) {
      unsigned alive = 0;
      if constexpr (!whole) {
        alive = part_of<S::lanes>(words[s], lane0);
        if (!alive) continue;
      }
      const std::ptrdiff_t o = t.neighbour[s];
      const Bond<Real> bd = bond<Real, per_lane>(u, o, centre, slot);
      const V e = fit_argument<whole, Real>(bd.e, law);
      const V pressure =
          S::template constant<per_lane>(slot, pressure_weight) * (own_theta + S::load(theta + o));
      V scale = pressure * R(e) + S::template constant<per_lane>(slot, distortion_weight) * (bd.e * H(e));
      if constexpr (by_stress) {
        const V stress =
            law.stress_per_stretch * (bd.e * G(e)) + law.stress_per_theta * (own_theta + S::load(theta + o));
        const typename S::Mask breaks =
            S::expand(alive, bits) & (stress > strength + S::load(f.extra_strength + x + o));
        if (__builtin_expect(S::any(breaks), 0)) {
          const unsigned gone = S::compress(breaks, bits);
          words[s] = static_cast<std::uint16_t>(words[s] & ~(gone << lane0));
          broken += __builtin_popcount(gone);
          alive &= ~gone;
        }
      }
      if constexpr (!whole) scale = S::keep(scale, S::expand(alive, bits));
      for (int c = 0; c < 3; ++c) {
        own[c] -= scale * bd.minus_y[c];
        S::store(a[c] + o, S::load(a[c] + o) + scale * bd.minus_y[c]);
      }
    }
    for (int c = 0; c < 3; ++c) S::store(a[c], S::load(a[c]) + own[c]);
  }
  return broken;
}

template <class Real, bool per_lane>
int force_by_state(const RowFields<Real>& f, const RowTables<Real>& t, const BondLaw<Real>& law, int b,
                   const Real* constants) {
  if (f.state[b] == touched) {
    return law.stress_per_stretch > 0 ? block_force<Real, false, per_lane, true>(f, t, law, b, constants)
                                      : block_force<Real, false, per_lane, false>(f, t, law, b, constants);
  }
  if (f.state[b] == intact) return block_force<Real, true, per_lane, false>(f, t, law, b, constants);
  for (int lane0 = 0; lane0 < block; lane0 += Simd<Real>::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    calm_force<Real, per_lane>(f, t, law, x, constants + (per_lane ? lane0 : 0));
  }
  return 0;
}

template <class Real>
int force(const RowFields<Real>* rows, const RowTables<Real>* tables, int nz, const BondLaw<Real>& law,
          int owned_blocks) {
  int broken = 0;
  for (int b = rows[0].first_block; b < rows[0].last_block; ++b) {
    if (rows[0].skip[b]) continue;
    int in_block = 0;
    for (int k = 0; k < nz; ++k) {
      const RowTables<Real>& t = tables[k];
      in_block += t.ends[b] ? force_by_state<Real, true>(rows[k], t, law, b, t.ends[b])
                            : force_by_state<Real, false>(rows[k], t, law, b, t.interior);
    }
    if (b >= 0 && b < owned_blocks) broken += in_block;
  }
  return broken;
}

template <class Real>
void drift(const DriftRow<Real>& r, const DriftSettings& d) {
  using S = Simd<Real>;
  using V = typename S::V;
  const Real dt = static_cast<Real>(d.dt), gravity = static_cast<Real>(d.gravity),
             lift = static_cast<Real>(d.lift), inverse_dx = static_cast<Real>(d.inverse_dx);
  Real lo[3], hi[3];
  for (int c = 0; c < 3; ++c) {
    lo[c] = static_cast<Real>(d.box_lo[c]);
    hi[c] = static_cast<Real>(d.box_hi[c]);
  }
  for (int b = 0; b < r.blocks; ++b) {
    typename S::Mask inside = {};
    for (int x = b * block; x < (b + 1) * block; x += S::lanes) {
      const V mobile = S::load(r.mobile + x);
      const V depth = (-(S::load(r.u[2] + x) + r.z)) * inverse_dx + Real(0.5);
      const V submerged = S::min(S::max(depth, V{}), S::splat(1));
      const V weight_and_lift = lift * submerged - gravity;
      S::store(r.theta + x, V{});
      const V reference[3] = {S::load(r.x + x), S::splat(r.y), S::splat(r.z)};
      typename S::Mask in_box = (mobile != V{});
      for (int c = 0; c < 3; ++c) {
        V a = S::load(r.acceleration[c] + x);
        if (c == 2) a += weight_and_lift;
        S::store(r.acceleration[c] + x, V{});
        const V v = (S::load(r.v[c] + x) + dt * a) * mobile;
        S::store(r.v[c] + x, v);
        // Neumaier-style compensated sum: steps of 1e-5 m on displacements of a metre.
        const V u = S::load(r.u[c] + x);
        const V step = dt * v + S::load(r.residual[c] + x);
        const V sum = u + step;
        S::store(r.residual[c] + x, step - (sum - u));
        S::store(r.u[c] + x, sum);
        const V position = reference[c] + sum;
        in_box &= (position > lo[c]) & (position < hi[c]);
      }
      inside |= in_box;
    }
    r.near_hull[b] = S::any(inside);
  }
}

template <class Real>
constexpr Passes<Real> passes() {
  return {dilatation<Real>,
          force<Real>,
          drift<Real>,
          {linear_passes<Real, 1>(), linear_passes<Real, 2>(), linear_passes<Real, 3>(),
           linear_passes<Real, 4>(), linear_passes<Real, 5>()},
          roughness<Real>};
}

}  // namespace
}  // namespace icebow
