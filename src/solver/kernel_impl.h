// Included by kernel_<name>.cpp with ICEBOW_LANES defined: see kernel.h.
//
// Vectors are GCC's and Clang's portable vector types, so one text serves every instruction set. Everything
// is in an unnamed namespace: two widths must never share a symbol.
#include <cstring>

#include "solver/kernel.h"
#include "solver/lattice.h"

namespace icebow {
namespace {

constexpr int lanes = ICEBOW_LANES;
static_assert(block % lanes == 0);

typedef float VecF __attribute__((vector_size(4 * lanes)));
typedef std::int32_t VecI __attribute__((vector_size(4 * lanes)));
typedef float VecFUnaligned __attribute__((vector_size(4 * lanes), aligned(4), may_alias));

inline VecF load(const float* p) {
  return *reinterpret_cast<const VecFUnaligned*>(p);
}
inline void store(float* p, VecF v) {
  *reinterpret_cast<VecFUnaligned*>(p) = v;
}
inline VecF splat(float x) {
  return x - VecF{};
}
inline VecF max(VecF a, VecF b) {
  return a > b ? a : b;
}
inline VecF min(VecF a, VecF b) {
  return a < b ? a : b;
}
inline VecF keep(VecF v, VecI mask) {
  return (VecF)((VecI)v & mask);
}

inline VecI lane_bits() {
  VecI bits;
  for (int l = 0; l < lanes; ++l) bits[l] = 1 << l;
  return bits;
}

// Lane l of the mask is all ones where bit l of the word is set.
inline VecI expand(unsigned word, VecI bits) {
  return ((static_cast<int>(word) - VecI{}) & bits) != 0;
}

inline unsigned compress(VecI mask, VecI bits) {
  const VecI set = mask & bits;
  unsigned word = 0;
  for (int l = 0; l < lanes; ++l) word |= static_cast<unsigned>(set[l]);
  return word;
}

inline bool any(VecI mask) {
  std::uint64_t part[sizeof(VecI) / 8], all = 0;
  std::memcpy(part, &mask, sizeof mask);
  for (std::uint64_t p : part) all |= p;
  return all != 0;
}

// A fit with its coefficients repeated for all lanes.
template <int n>
struct Polynomial {
  explicit Polynomial(const float (&coefficients)[n]) {
    for (int power = 0; power < n; ++power) c[power] = splat(coefficients[power]);
  }
  VecF operator()(VecF e) const {
    VecF p = c[n - 1];
    for (int power = n - 2; power >= 0; --power) p = p * e + c[power];
    return p;
  }
  VecF c[n];
};

// A constant of a slot: one for all lanes in the interior, one for each near the ends of the sheet.
template <bool per_lane>
inline VecF constant(const float* slot, int which) {
  if constexpr (per_lane) return load(slot + which * block);
  return splat(slot[which]);
}
template <bool per_lane>
constexpr int slot_size = constants_per_slot*(per_lane ? block : 1);

// A bond seen from its higher end: minus eta, minus y, and e = q / L^2 with q = eta . (eta + 2 xi) = n . (n -
// 2 xi).
struct Bond {
  VecF minus_y[3];
  VecF e;
};

template <bool per_lane>
inline Bond bond(const float* u0, const float* u1, const float* u2, const VecF* centre, const float* slot) {
  const float* u[3] = {u0, u1, u2};
  Bond b;
  VecF q = {};
  for (int c = 0; c < 3; ++c) {
    const VecF xi = constant<per_lane>(slot, c);
    const VecF minus_eta = centre[c] - load(u[c]);
    b.minus_y[c] = minus_eta - xi;
    q += minus_eta * (b.minus_y[c] - xi);
  }
  b.e = q * constant<per_lane>(slot, inverse_L2);
  return b;
}

// Bits of `lanes` particles within a 16-bit word.
inline unsigned part_of(std::uint16_t word, int lane0) {
  return (word >> lane0) & ((1u << lanes) - 1u);
}

// The law of a block: short fits while it is intact; and where its fits are evaluated.
template <bool intact>
inline const auto& fits_of(const BondLaw& law) {
  if constexpr (intact) {
    return law.small;
  } else {
    return law.wide;
  }
}
template <bool intact>
inline VecF fit_argument(VecF e, const BondLaw& law) {
  if constexpr (intact) return e;
  return max(e, splat(law.e_min));
}

// theta of a block's bonds. An intact block does not look at the bits; where a bond leaves the range of the
// short fits or wants to break, the block is marked as touched, and the bond breaks in the next step if it
// still wants to.
template <bool intact, bool per_lane>
int dilatation_block(const RowFields& f, const RowTables& t, const BondLaw& law, int b) {
  const VecI bits = lane_bits();
  const Polynomial G(fits_of<intact>(law).G);
  const int n_slots = t.n_slots;
  const std::ptrdiff_t* const neighbour = t.neighbour;
  std::uint16_t* const words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
  const VecF e_break = splat(law.e_break);
  VecF e_max = {}, e_min = {};
  int broken = 0;
  for (int lane0 = 0; lane0 < block; lane0 += lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const float *const u0 = f.u[0] + x, *const u1 = f.u[1] + x, *const u2 = f.u[2] + x;
    const VecF centre[3] = {load(u0), load(u1), load(u2)};
    float* const theta = f.theta + x;
    const float* slot = per_lane ? t.ends[b] + lane0 : t.interior;
    VecF own = {};
    for (int s = 0; s < n_slots; ++s, slot += slot_size<per_lane>) {
      unsigned alive = 0;
      if constexpr (!intact) {
        alive = part_of(words[s], lane0);
        if (!alive) continue;
      }
      const std::ptrdiff_t n = neighbour[s];
      const Bond bd = bond<per_lane>(u0 + n, u1 + n, u2 + n, centre, slot);
      VecF term = constant<per_lane>(slot, dilatation_weight) * (bd.e * G(fit_argument<intact>(bd.e, law)));
      if constexpr (intact) {
        e_max = max(e_max, bd.e);
        e_min = min(e_min, bd.e);
      } else {
        const VecI mask = expand(alive, bits);
        const VecI breaks = mask & (bd.e > e_break);
        if (__builtin_expect(any(breaks), 0)) {
          const unsigned gone = compress(breaks, bits);
          words[s] = static_cast<std::uint16_t>(words[s] & ~(gone << lane0));
          broken += __builtin_popcount(gone);
        }
        term = keep(term, mask & ~breaks);
      }
      own += term;
      store(theta + n, load(theta + n) + term);
    }
    store(theta, load(theta) + own);
  }
  if (intact && any((e_max > law.e_small) | (e_min < -law.e_small))) f.touched[b] = 1;
  return broken;
}

int dilatation(const RowFields* rows, const RowTables* tables, int nz, const BondLaw& law, int owned_blocks) {
  int broken = 0;
  for (int b = rows[0].first_block; b < rows[0].last_block; ++b) {
    int in_block = 0;
    for (int k = 0; k < nz; ++k) {
      const RowFields& f = rows[k];
      const RowTables& t = tables[k];
      if (t.ends[b]) {
        in_block += dilatation_block<false, true>(f, t, law, b);
      } else if (f.touched[b]) {
        in_block += dilatation_block<false, false>(f, t, law, b);
      } else {
        dilatation_block<true, false>(f, t, law, b);
      }
    }
    if (b >= 0 && b < owned_blocks) broken += in_block;
  }
  return broken;
}

template <bool intact, bool per_lane>
void force_block(const RowFields& f, const RowTables& t, const BondLaw& law, int b) {
  const VecI bits = lane_bits();
  const Polynomial R(fits_of<intact>(law).R), H(fits_of<intact>(law).H);
  const int n_slots = t.n_slots;
  const std::ptrdiff_t* const neighbour = t.neighbour;
  const std::uint16_t* const words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
  for (int lane0 = 0; lane0 < block; lane0 += lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const float *const u0 = f.u[0] + x, *const u1 = f.u[1] + x, *const u2 = f.u[2] + x;
    const float* const theta = f.theta + x;
    float* const a[3] = {f.acceleration[0] + x, f.acceleration[1] + x, f.acceleration[2] + x};
    const VecF centre[3] = {load(u0), load(u1), load(u2)};
    const VecF own_theta = load(theta);
    const float* slot = per_lane ? t.ends[b] + lane0 : t.interior;
    VecF own[3] = {};
    for (int s = 0; s < n_slots; ++s, slot += slot_size<per_lane>) {
      unsigned alive = 0;
      if constexpr (!intact) {
        alive = part_of(words[s], lane0);
        if (!alive) continue;
      }
      const std::ptrdiff_t n = neighbour[s];
      const Bond bd = bond<per_lane>(u0 + n, u1 + n, u2 + n, centre, slot);
      const VecF e = fit_argument<intact>(bd.e, law);
      const VecF pressure = constant<per_lane>(slot, pressure_weight) * (own_theta + load(theta + n));
      VecF scale = pressure * R(e) + constant<per_lane>(slot, distortion_weight) * (bd.e * H(e));
      if constexpr (!intact) scale = keep(scale, expand(alive, bits));
      for (int c = 0; c < 3; ++c) {
        own[c] -= scale * bd.minus_y[c];
        store(a[c] + n, load(a[c] + n) + scale * bd.minus_y[c]);
      }
    }
    for (int c = 0; c < 3; ++c) store(a[c], load(a[c]) + own[c]);
  }
}

void force(const RowFields* rows, const RowTables* tables, int nz, const BondLaw& law) {
  for (int b = rows[0].first_block; b < rows[0].last_block; ++b) {
    for (int k = 0; k < nz; ++k) {
      const RowFields& f = rows[k];
      const RowTables& t = tables[k];
      if (t.ends[b]) {
        force_block<false, true>(f, t, law, b);
      } else if (f.touched[b]) {
        force_block<false, false>(f, t, law, b);
      } else {
        force_block<true, false>(f, t, law, b);
      }
    }
  }
}

void drift(const DriftRow& r, const DriftSettings& d) {
  for (int b = 0; b < r.blocks; ++b) {
    VecI inside = {};
    for (int x = b * block; x < (b + 1) * block; x += lanes) {
      const VecF mobile = load(r.mobile + x);
      const VecF depth = (-(load(r.u[2] + x) + r.z)) * d.inverse_dx + 0.5f;
      const VecF submerged = min(max(depth, VecF{}), splat(1.0f));
      const VecF weight_and_lift = d.lift * submerged - d.gravity;
      store(r.theta + x, VecF{});
      const VecF reference[3] = {load(r.x + x), splat(r.y), splat(r.z)};
      VecI in_box = (VecI)(mobile != 0.0f);
      for (int c = 0; c < 3; ++c) {
        VecF a = load(r.acceleration[c] + x);
        if (c == 2) a += weight_and_lift;
        store(r.acceleration[c] + x, VecF{});
        const VecF v = (load(r.v[c] + x) + d.dt * a) * mobile;
        store(r.v[c] + x, v);
        // Neumaier-style compensated sum: steps of 1e-5 m on displacements of a metre.
        const VecF u = load(r.u[c] + x);
        const VecF step = d.dt * v + load(r.residual[c] + x);
        const VecF sum = u + step;
        store(r.residual[c] + x, step - (sum - u));
        store(r.u[c] + x, sum);
        const VecF position = reference[c] + sum;
        in_box &= (position > d.box_lo[c]) & (position < d.box_hi[c]);
      }
      inside |= in_box;
    }
    r.near_hull[b] = any(inside);
  }
}

}  // namespace
}  // namespace icebow
