// Bonds of a block that break; included by kernel_impl.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/kernel/family_impl.h"

namespace icebow {
namespace {

inline void kill(std::uint16_t* words, int per_block, std::uint64_t gone) {
  words[-per_block] = static_cast<std::uint16_t>(words[-per_block] & ~gone);
  words[0] = static_cast<std::uint16_t>(words[0] & ~(gone >> 16));
  words[per_block] = static_cast<std::uint16_t>(words[per_block] & ~(gone >> 32));
}

// Bonds with these lower ends' bits, as alive() counts them; those of other ranks' particles are theirs to
// count.
inline void count(const FamilyWord& fw, int b, int blocks, std::uint64_t gone, Broken& broken) {
  const std::uint64_t before = b > 0 ? 0 : 0xffffu, after = b + 1 < blocks ? 0 : std::uint64_t(0xffff) << 32;
  if (fw.own) broken.own += __builtin_popcountll(gone & ~(before | after));
  // The lower end is an image, which no rank works on: the other end's rank counts.
  if (fw.image) broken.image += __builtin_popcountll(gone);
}

// Of a block's bonds number n those whose stretch or stress is too high: a bit a particle. The same
// arithmetic from both ends.
template <class Real, bool by_stress>
unsigned overstrained(const RowFields<Real>& f, const FamilyRow<Real>& row, const FamilyBond<Real>& fb,
                      const BondLaw<Real>& law, int b) {
  using S = Simd<Real>;
  using V = typename S::V;
  const typename S::Mask bits = S::lane_bits();
  const typename S::template Polynomial<LawDegrees<Real>::wide + 1> G(law.wide.G);
  unsigned all = 0;
  for (int lane0 = 0; lane0 < block; lane0 += S::lanes) {
    const std::ptrdiff_t x = std::ptrdiff_t(b) * block + lane0;
    const Real* const u[3] = {f.u[0] + x, f.u[1] + x, f.u[2] + x};
    const V centre[3] = {S::load(u[0]), S::load(u[1]), S::load(u[2])};
    const V e = bond_at(row, fb, u, centre).e;
    const Real *const extra = f.extra_strength + x, *const theta = f.theta + x;
    const V strength = S::load(extra) + S::load(extra + fb.neighbour);
    typename S::Mask breaks;
    if constexpr (by_stress) {
      const V stretch = e * G(fit_argument<wide>(e, law)) * Real(0.5);
      const V both = S::load(theta) + S::load(theta + fb.neighbour);
      breaks = law.stress_per_stretch * stretch + law.stress_per_theta * both > strength + Real(1);
    } else {
      breaks = e > strength + law.e_break;
    }
    all |= (S::compress(breaks, bits) & ((1u << S::lanes) - 1u)) << lane0;
  }
  return all;
}

// Breaks a block's bonds that are overstrained, one by one. Returns whether there were any, or whether the
// block was not known to be cracked and is.
template <class Real, bool by_stress>
bool break_bonds(const RowFields<Real>& f, const FamilyTables<Real>& t, const BondLaw<Real>& law, int b,
                 Broken& broken) {
  std::uint16_t* const words = f.bits + std::ptrdiff_t(b) * f.bits_per_block;
  std::uint16_t* const there = f.there + std::ptrdiff_t(b) * f.there_per_block;
  bool changed = false, missing = false;
  int n = 0;
  for (int r = 0; r < t.rows; ++r) {
    for (const int end = n + t.row[r].bonds; n < end; ++n) {
      const FamilyWord& fw = t.word[n];
      unsigned now = alive(words + fw.word, f.bits_per_block, fw.shift);
      const unsigned gone = now ? now & overstrained<Real, by_stress>(f, t.row[r], t.bond[n], law, b) : 0u;
      if (gone) {
        count(fw, b, f.blocks, std::uint64_t(gone) << fw.shift, broken);
        kill(words + fw.word, f.bits_per_block, std::uint64_t(gone) << fw.shift);
        now &= ~gone;
      }
      changed |= there[fw.place] != now;
      there[fw.place] = static_cast<std::uint16_t>(now);
      missing |= now != (t.whole[b] ? t.whole[b][n] : 0xffffu);
    }
  }
  if (missing) f.state[b] |= cracked;
  return changed;
}

}  // namespace
}  // namespace icebow
