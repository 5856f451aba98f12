// Particles that the hull has crushed since the last step: all their bonds are to break, at both ends.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/kernel/kernel.h"
#include "solver/lattice/lattice.h"

namespace icebow {

template <class Real>
class CrushWatch {
 public:
  explicit CrushWatch(const Layout& layout);

  void start_step();
  // Blocks of column jl with a newly crushed particle within a bond's reach. Columns upwards from 0.
  // `extra_strength` points to the first own particle's.
  const std::uint8_t* near(const Passes<Real>& passes, const Real* extra_strength, int jl);
  // All that are crushed count as new in the next step: the ice has been renumbered, or comes from elsewhere.
  void forget();

 private:
  void look(const Passes<Real>& passes, const Real* extra_strength, int jl);
  void mark(int jl, int b);

  int blocks_, columns_, nz_;
  std::ptrdiff_t stride_;
  int looked_at_ = 0;                 // columns below are
  bool marked_ = false;               // anywhere
  std::vector<std::uint16_t> known_;  // [column -reach .. columns + reach - 1][layer][block -1 .. blocks]
  std::vector<std::uint16_t> now_;    // of a row
  std::vector<std::uint8_t> near_;    // [own column][own block]
};

}  // namespace icebow
