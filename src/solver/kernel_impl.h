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

template <int n>
inline VecF polynomial(const float (&c)[n], VecF e) {
  VecF p = splat(c[n - 1]);
  for (int power = n - 2; power >= 0; --power) p = p * e + c[power];
  return p;
}

struct Bond {
  VecF eta[3];
  VecF e;  // q / L^2
};

inline Bond bond(const float* const* u, const VecF* centre, const SlotGeometry& slot) {
  Bond b;
  VecF q = {};
  for (int c = 0; c < 3; ++c) {
    b.eta[c] = load(u[c] + slot.neighbour) - centre[c];
    q += (b.eta[c] + slot.two_xi[c]) * b.eta[c];
  }
  b.e = q * slot.inverse_L2;
  return b;
}

// A weight of a slot: one for all lanes in the interior, one per lane near the ends of the sheet.
template <bool per_lane>
inline VecF weight(const float* table, int slot, Weight w, int lane0) {
  if constexpr (per_lane) return load(table + (slot * weights_per_slot + w) * block + lane0);
  return splat(table[slot * weights_per_slot + w]);
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

// theta of one block. Intact blocks skip the bits; returns false where a bond of an intact block leaves the
// range of the short fits (or wants to break): the caller marks the block as touched and comes again.
template <bool intact, bool per_lane>
bool dilatation_block(const RowFields& f, const RowTables& t, const float* table, const BondLaw& law, int b,
                      int& broken) {
  const VecI bits = lane_bits();
  const auto& fits = fits_of<intact>(law);
  for (int lane0 = 0; lane0 < block; lane0 += lanes) {
    const int x = b * block + lane0;
    const float* u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const VecF centre[3] = {load(u[0]), load(u[1]), load(u[2])};
    std::uint16_t* words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
    VecF theta = {}, e_max = {}, e_min = {};
    for (int s = 0; s < t.n_slots; ++s) {
      const Bond bd = bond(u, centre, t.slots[s]);
      VecF term = weight<per_lane>(table, s, dilatation_weight, lane0) *
                  (bd.e * polynomial(fits.G, fit_argument<intact>(bd.e, law)));
      if constexpr (intact) {
        e_max = max(e_max, bd.e);
        e_min = min(e_min, bd.e);
      } else {
        const unsigned alive = part_of(words[s], lane0);
        const VecI mask = expand(alive, bits);
        const VecI breaks = mask & (bd.e > law.e_break);
        if (__builtin_expect(any(breaks), 0)) {
          const unsigned gone = compress(breaks, bits);
          words[s] = static_cast<std::uint16_t>(words[s] & ~(gone << lane0));
          broken += __builtin_popcount(gone);
        }
        term = keep(term, mask & ~breaks);
      }
      theta += term;
    }
    if (intact && any((e_max > law.e_small) | (e_min < -law.e_small))) return false;
    store(f.theta + x, theta);
  }
  return true;
}

int dilatation(const RowFields& f, const RowTables& t, const BondLaw& law) {
  int broken = 0;
  for (int b = 0; b < f.blocks; ++b) {
    const float* per_lane = t.lanes[b];
    if (per_lane) {
      dilatation_block<false, true>(f, t, per_lane, law, b, broken);
      continue;
    }
    if (!f.touched[b]) {
      if (dilatation_block<true, false>(f, t, t.interior, law, b, broken)) continue;
      f.touched[b] = 1;
    }
    dilatation_block<false, false>(f, t, t.interior, law, b, broken);
  }
  return broken;
}

template <bool intact, bool per_lane>
void force_block(const RowFields& f, const RowTables& t, const float* table, const BondLaw& law, float dt,
                 int b) {
  const VecI bits = lane_bits();
  const auto& fits = fits_of<intact>(law);
  for (int lane0 = 0; lane0 < block; lane0 += lanes) {
    const int x = b * block + lane0;
    const float* u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const VecF centre[3] = {load(u[0]), load(u[1]), load(u[2])};
    const VecF theta = load(f.theta + x);
    const std::uint16_t* words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
    VecF acceleration[3] = {};
    for (int s = 0; s < t.n_slots; ++s) {
      const SlotGeometry& slot = t.slots[s];
      const Bond bd = bond(u, centre, slot);
      const VecF e = fit_argument<intact>(bd.e, law);
      const VecF theta_pair = theta + load(f.theta + x + slot.neighbour);
      VecF scale = weight<per_lane>(table, s, pressure_weight, lane0) * theta_pair * polynomial(fits.R, e) +
                   weight<per_lane>(table, s, distortion_weight, lane0) * (bd.e * polynomial(fits.H, e));
      if constexpr (!intact) scale = keep(scale, expand(part_of(words[s], lane0), bits));
      for (int c = 0; c < 3; ++c) acceleration[c] += scale * (bd.eta[c] + slot.xi[c]);
    }
    for (int c = 0; c < 3; ++c) store(f.v[c] + x, load(f.v[c] + x) + dt * acceleration[c]);
  }
}

void force(const RowFields& f, const RowTables& t, const BondLaw& law, float dt) {
  for (int b = 0; b < f.blocks; ++b) {
    if (t.lanes[b]) {
      force_block<false, true>(f, t, t.lanes[b], law, dt, b);
    } else if (f.touched[b]) {
      force_block<false, false>(f, t, t.interior, law, dt, b);
    } else {
      force_block<true, false>(f, t, t.interior, law, dt, b);
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
      store(r.v[2] + x, load(r.v[2] + x) + d.dt * (d.lift * submerged - d.gravity));
      const VecF reference[3] = {load(r.x + x), splat(r.y), splat(r.z)};
      VecI in_box = (VecI)(mobile != 0.0f);
      for (int c = 0; c < 3; ++c) {
        const VecF v = load(r.v[c] + x) * mobile;
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
