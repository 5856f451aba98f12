#include "solver/kernel/crush_watch.h"

#include <algorithm>

namespace icebow {

template <class Real>
CrushWatch<Real>::CrushWatch(const Layout& layout)
    : blocks_(layout.blocks),
      columns_(layout.columns),
      nz_(layout.nz),
      stride_(layout.stride),
      known_(std::size_t(columns_ + 2 * reach) * nz_ * (blocks_ + 2)),
      now_(blocks_ + 2),
      near_(std::size_t(columns_) * blocks_) {}

template <class Real>
void CrushWatch<Real>::start_step() {
  looked_at_ = -reach;
  if (marked_) std::fill(near_.begin(), near_.end(), std::uint8_t(0));
  marked_ = false;
}

template <class Real>
const std::uint8_t* CrushWatch<Real>::near(const Passes<Real>& passes, const Real* extra_strength, int jl) {
  for (; looked_at_ < std::min(jl + reach + 1, columns_ + reach); ++looked_at_)
    look(passes, extra_strength, looked_at_);
  return &near_[std::size_t(jl) * blocks_];
}

template <class Real>
void CrushWatch<Real>::forget() {
  std::fill(known_.begin(), known_.end(), std::uint16_t(0));
}

template <class Real>
void CrushWatch<Real>::look(const Passes<Real>& passes, const Real* extra_strength, int jl) {
  for (int k = 0; k < nz_; ++k) {
    passes.negative(extra_strength + (std::ptrdiff_t(jl) * nz_ + k) * stride_ - block, blocks_ + 2,
                    now_.data());
    std::uint16_t* const known = &known_[(std::size_t(jl + reach) * nz_ + k) * (blocks_ + 2)];
    if (std::equal(now_.begin(), now_.end(), known)) continue;
    for (int b = -1; b <= blocks_; ++b)
      if (now_[b + 1] & ~known[b + 1]) mark(jl, b);
    std::copy(now_.begin(), now_.end(), known);
  }
}

template <class Real>
void CrushWatch<Real>::mark(int jl, int b) {
  marked_ = true;
  for (int column = std::max(jl - reach, 0); column <= std::min(jl + reach, columns_ - 1); ++column) {
    for (int beside = std::max(b - 1, 0); beside <= std::min(b + 1, blocks_ - 1); ++beside)
      near_[std::size_t(column) * blocks_ + beside] = 1;
  }
}

template class CrushWatch<float>;
template class CrushWatch<double>;

}  // namespace icebow
