#include "solver/kernel/linear_blocks.h"

#include <algorithm>

namespace icebow {

template <class Real>
LinearBlocks<Real>::LinearBlocks(const Lattice& lattice, const Layout& layout, double limit)
    : blocks_(layout.blocks),
      columns_(layout.columns),
      nz_(layout.nz),
      j0_(layout.j0),
      lowest_(-lattice.mirrored_columns()),
      ny_(lattice.ny),
      limit2_(nz_ <= most_linear_layers ? static_cast<Real>(limit * limit * lattice.dx * lattice.dx) : 0),
      facts_(std::size_t(columns_ + 2 * reach) * (blocks_ + 2),
             flat_within | flat_across | whole | whole_around),
      linear_(std::size_t(columns_) * blocks_),
      skip_(std::size_t(columns_ + reach) * (blocks_ + 2)),
      all_(blocks_ + 2),
      quiet_(blocks_ + 2),
      calmed_(std::size_t(nz_) * (blocks_ + 2)) {
  for (int l = -ghost_blocks * block; l < (blocks_ + ghost_blocks) * block; ++l) {
    const int i = layout.i0 + l;
    has_next_.push_back(i >= 0 && i + 1 < lattice.nx ? Real(1) : Real(0));
  }
}

template <class Real>
void LinearBlocks<Real>::settle(const Ice& ice, int jl) {
  // A block's surroundings end `reach` columns from it; whether its neighbours are linear depends on theirs.
  for (; measured_ < std::min(jl + 2 * reach + 1, columns_ + reach); ++measured_) {
    measure(ice, measured_);
    if (measured_ < columns_) look_for_touched(ice, measured_);
  }
  for (decided_ = std::max(decided_, 0); decided_ < std::min(jl + reach + 1, columns_); ++decided_)
    decide(decided_);
  settle_quiet(jl);
  calm_down(ice, jl);
}

template <class Real>
void LinearBlocks<Real>::measure(const Ice& ice, int jl) {
  const int j = j0_ + jl;
  if (j < lowest_ || j >= ny_) return;
  LinearFields<Real> f = ice.fields;
  for (const Real*& u : f.u) u += jl * f.column;
  // The copies north of the last one end there.
  if (j + 1 >= ny_ || jl + 1 >= columns_ + reach) f.column = 0;
  for (int b = -1; b <= blocks_; ++b) {
    const Roughness<Real> r = ice.passes.roughness(f, nz_, b, &has_next_[ghost_blocks * block]);
    facts_[followed(jl, b)] =
        static_cast<std::uint8_t>((r.within <= limit2_ ? flat_within : 0) |
                                  (r.across <= limit2_ ? flat_across : 0) | whole | whole_around);
  }
}

template <class Real>
void LinearBlocks<Real>::look_for_touched(const Ice& ice, int jl) {
  std::uint8_t* const facts = &facts_[followed(jl, 0)];
  const std::uint8_t* state = states(ice, jl) + 1;
  for (int k = 0; k < nz_; ++k, state += blocks_ + 2) {
    for (int b = -1; b <= blocks_; ++b) {
      if (state[b] != touched) continue;
      facts[b] &= static_cast<std::uint8_t>(~whole);
      for (int beside = std::max(b - 1, -1); beside <= std::min(b + 1, blocks_); ++beside)
        facts[beside] &= static_cast<std::uint8_t>(~whole_around);
    }
  }
}

// Clears what does not have all these facts in column jl.
template <class Real>
void LinearBlocks<Real>::require(std::vector<std::uint8_t>& all, int jl, std::uint8_t facts) const {
  const std::uint8_t* const known = &facts_[followed(jl, -1)];
  for (std::size_t b = 0; b < all.size(); ++b)
    all[b] = static_cast<std::uint8_t>(all[b] & ((known[b] & facts) == facts));
}

template <class Real>
void LinearBlocks<Real>::decide(int jl) {
  std::fill(all_.begin(), all_.end(), std::uint8_t(1));
  for (int other = jl - reach; other <= jl; ++other)
    require(all_, other, flat_within | flat_across | whole_around);
  for (int other = jl + 1; other < jl + reach; ++other) require(all_, other, flat_within | flat_across);
  require(all_, jl + reach, flat_within);
  std::copy_n(all_.begin() + 1, blocks_, linear_.begin() + std::ptrdiff_t(jl) * blocks_);
}

// Quiet: no bond to a higher end is stretched enough for anything to happen to it. A quiet block needs no
// pass over bonds where it is whole and all of this rank's that it could add to are linear.
template <class Real>
void LinearBlocks<Real>::settle_quiet(int jl) {
  std::fill(quiet_.begin(), quiet_.end(), std::uint8_t(1));
  for (int other = jl; other < jl + reach; ++other) require(quiet_, other, flat_within | flat_across);
  require(quiet_, jl + reach, flat_within);
  all_ = quiet_;
  require(all_, jl, whole);
  for (int upper = std::max(jl, 0); upper <= std::min(jl + reach, columns_ - 1); ++upper) {
    const std::uint8_t* const linear = &linear_[std::size_t(upper) * blocks_];
    for (int b = 0; b < blocks_; ++b) {
      if (linear[b]) continue;
      all_[b] = all_[b + 1] = all_[b + 2] = 0;
    }
  }
  std::copy(all_.begin(), all_.end(), skip_.begin() + static_cast<std::ptrdiff_t>(followed(jl, -1)));
}

template <class Real>
void LinearBlocks<Real>::calm_down(const Ice& ice, int jl) {
  std::uint8_t* const state = states(ice, jl);
  for (std::size_t n = 0; n < calmed_.size(); ++n) {
    calmed_[n] = quiet_[n % quiet_.size()] && state[n] != touched;
    if (calmed_[n]) state[n] = calm;
  }
}

template <class Real>
void LinearBlocks<Real>::keep_calm(const Ice& ice, int jl) const {
  std::uint8_t* const state = states(ice, jl);
  for (std::size_t n = 0; n < calmed_.size(); ++n)
    if (calmed_[n]) state[n] = calm;
}

template <class Real>
std::int64_t LinearBlocks<Real>::count() const {
  return std::count(linear_.begin(), linear_.end(), std::uint8_t(1));
}

template class LinearBlocks<float>;
template class LinearBlocks<double>;

}  // namespace icebow
