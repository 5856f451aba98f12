// Which blocks take the linear passes in a step.
//
// A block of a column (all its layers) is linear where none of its particles' bonds is broken and where
// nearest neighbours within a bond's reach are displaced by nearly the same vector: along each axis their
// difference is at most `limit` dx. So |eta| <= sqrt(3) limit |xi| for all its bonds: rotations and strains
// are small, and the law linear in eta is off by at most |eta|/|xi| in a bond's direction and its square/2 in
// its stretch (docs/theory.md).
//
// Found anew in each step from displacements and cracks alone, so it is the same on any number of ranks.
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
  void start_step() { measured_ = -reach; }

  // What a step's passes know about the ice.
  struct Ice {
    const Passes<Real>& passes;
    LinearFields<Real> fields;  // of column 0
    std::uint8_t* states;       // of the own blocks of the lowest layer of a column
    std::ptrdiff_t layer;       // to those of the layer above
    const std::uint8_t* crush;  // RowFields::crush of the column
  };
  // Settles which blocks of column jl are linear, and calls those calm. Columns upwards from 0.
  void settle(const Ice& ice, int jl);

  const std::uint8_t* linear(int jl) const { return &linear_[std::size_t(jl) * blocks_]; }
  std::int64_t count() const;  // linear blocks in the last step

 private:
  // Flatness of a block of a column.
  std::uint8_t* facts(int jl) { return &facts_[std::size_t(jl + reach) * blocks_]; }
  void measure(const Ice& ice, int jl);
  bool require(std::uint8_t* linear, int jl, std::uint8_t wanted);

  int blocks_, columns_, nz_, j0_, lowest_, ny_;  // lowest_: column of the sheet, mirror images included
  Real limit2_;
  int measured_ = 0;                  // columns below are
  std::vector<Real> has_next_;        // ghost blocks first
  std::vector<std::uint8_t> facts_;   // [column -reach .. columns + reach - 1][block]
  std::vector<std::uint8_t> linear_;  // [own column][block]
};

}  // namespace icebow
