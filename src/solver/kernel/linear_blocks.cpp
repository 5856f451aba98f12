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
      facts_(std::size_t(columns_ + 2 * reach) * blocks_, flat_within | flat_across),
      linear_(std::size_t(columns_) * blocks_) {
  for (int l = -ghost_blocks * block; l < (blocks_ + ghost_blocks) * block; ++l) {
    const int i = layout.i0 + l;
    has_next_.push_back(i >= 0 && i + 1 < lattice.nx ? Real(1) : Real(0));
  }
}

// A block's surroundings end `reach` columns from it.
template <class Real>
void LinearBlocks<Real>::settle(const Ice& ice, int jl) {
  for (; measured_ < std::min(jl + reach + 1, columns_ + reach); ++measured_) measure(ice, measured_);
  std::uint8_t* const linear = &linear_[std::size_t(jl) * blocks_];
  for (int b = 0; b < blocks_; ++b) linear[b] = !ice.crush[b];
  // The own column first: in broken ice it is often the last.
  if (!require(linear, jl, flat_within | flat_across)) return;
  for (int other = jl - reach; other < jl + reach; ++other) require(linear, other, flat_within | flat_across);
  if (!require(linear, jl + reach, flat_within)) return;
  for (int k = 0; k < nz_; ++k)
    for (int b = 0; b < blocks_; ++b)
      linear[b] &= static_cast<std::uint8_t>(!(ice.states[k * ice.layer + b] & cracked));
  for (int k = 0; k < nz_; ++k) {
    for (int b = 0; b < blocks_; ++b)
      if (linear[b]) ice.states[k * ice.layer + b] = calm;
  }
}

template <class Real>
void LinearBlocks<Real>::measure(const Ice& ice, int jl) {
  const int j = j0_ + jl;
  if (j < lowest_ || j >= ny_) return;
  LinearFields<Real> f = ice.fields;
  for (const Real*& u : f.u) u += jl * f.column;
  // The copies north of the last one end there.
  if (j + 1 >= ny_ || jl + 1 >= columns_ + reach) f.column = 0;
  for (int b = 0; b < blocks_; ++b) {
    facts(jl)[b] = ice.passes.flatness(f, nz_, b, &has_next_[ghost_blocks * block], limit2_);
  }
}

// Whether any block is left.
template <class Real>
bool LinearBlocks<Real>::require(std::uint8_t* linear, int jl, std::uint8_t wanted) {
  const std::uint8_t* const known = facts(jl);
  std::uint8_t any = 0;
  for (int b = 0; b < blocks_; ++b)
    any |= linear[b] &= static_cast<std::uint8_t>((known[b] & wanted) == wanted);
  return any != 0;
}

template <class Real>
std::int64_t LinearBlocks<Real>::count() const {
  return std::count(linear_.begin(), linear_.end(), std::uint8_t(1));
}

template class LinearBlocks<float>;
template class LinearBlocks<double>;

}  // namespace icebow
