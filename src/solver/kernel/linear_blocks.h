// Which blocks take the linear passes in a step, and which then need no pass over bonds.
//
// A block of a column (all its layers) is linear where no bond that reaches into it is broken and where
// nearest neighbours within a bond's reach are displaced by nearly the same vector: along each axis their
// difference is at most `limit` dx. So |eta| <= sqrt(3) limit |xi| for all its bonds: rotations and strains
// are small, and the law linear in eta is off by at most |eta|/|xi| in a bond's direction and its square/2 in
// its stretch (docs/theory.md).
//
// Found anew in each step from displacements and states alone, so it is the same on any number of ranks. The
// passes over bonds still run for blocks next to others that are not linear; what they add to a linear one is
// then stored over.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/kernel/kernel.h"
#include "solver/lattice/lattice.h"

namespace icebow {

template <class Real>
class LinearBlocks {
 public:
  // limit 0: none ever.
  LinearBlocks(const Lattice& lattice, const Layout& layout, double limit);

  bool enabled() const { return limit2_ > 0; }
  void start_step() { measured_ = decided_ = -reach; }

  // What a step's passes know about the ice.
  struct Ice {
    const Passes<Real>& passes;
    LinearFields<Real> fields;  // of column 0
    std::uint8_t* states;       // of the blocks of the lowest layer of column -reach, the one at -1 first
  };
  // For the passes over bonds of column jl: settles skip(jl), is_linear of the columns up to jl + reach, and
  // makes quiet blocks calm. Columns upwards, from the lowest one that is followed.
  void settle(const Ice& ice, int jl);
  // Of the column just settled: blocks that were calm as it was are still, whatever a pass has made of them;
  // another rank may not have run it.
  void keep_calm(const Ice& ice, int jl) const;

  bool is_linear(int jl, int b) const { return linear_[std::size_t(jl) * blocks_ + b]; }
  const std::uint8_t* skip(int jl) const { return &skip_[followed(jl, 0)]; }
  std::int64_t count() const;  // linear blocks in the last step

 private:
  // What is known of a block of a column: nearest neighbours displaced alike within the column, and between
  // it and the next one; no layer touched in it, nor in the blocks beside it.
  enum : std::uint8_t { flat_within = 1, flat_across = 2, whole = 4, whole_around = 8 };
  std::size_t followed(int jl, int b) const { return std::size_t(jl + reach) * (blocks_ + 2) + b + 1; }
  void measure(const Ice& ice, int jl);
  void look_for_touched(const Ice& ice, int jl);
  void decide(int jl);
  void settle_quiet(int jl);
  void calm_down(const Ice& ice, int jl);
  std::uint8_t* states(const Ice& ice, int jl) const {
    return ice.states + std::size_t(jl + reach) * nz_ * (blocks_ + 2);
  }
  void require(std::vector<std::uint8_t>& all, int jl, std::uint8_t facts) const;

  int blocks_, columns_, nz_, j0_, lowest_, ny_;  // lowest_: column of the sheet, mirror images included
  Real limit2_;
  int measured_ = 0, decided_ = 0;         // columns below are
  std::vector<Real> has_next_;             // ghost blocks first
  std::vector<std::uint8_t> facts_;        // [column -reach .. columns + reach - 1][block -1 .. blocks]
  std::vector<std::uint8_t> linear_;       // own blocks
  std::vector<std::uint8_t> skip_;         // [column -reach .. columns - 1][block -1 .. blocks]
  std::vector<std::uint8_t> all_, quiet_;  // [block -1 .. blocks] of the column at hand
  std::vector<std::uint8_t> calmed_;       // [layer][block -1 .. blocks] of it
};

}  // namespace icebow
