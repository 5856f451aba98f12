// The families of the sheet's particles for the passes over bonds: where the other ends are, where the bonds'
// bits lie, and the weights, by class of row. A bond's bit is kept once, at its lower end (BondBits): of half
// of a family at the particle itself, of the other half at the other end.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "solver/kernel/kernel.h"
#include "solver/lattice/bond_weights.h"

namespace icebow {

template <class Real>
class Families {
 public:
  Families(const Lattice& lattice, const Layout& layout, const Stencil& stencil, const Material& material,
           const BondTableOptions& options);

  // Of the rows of this rank's column jl, by layer.
  const FamilyTables<Real>* column(int jl) const { return &rows_[std::size_t(jl) * layers_]; }

 private:
  // Rows whose distances to the port and starboard edges are equal (beyond twice the reach: both far) have
  // the same families. The first columns' bonds begin in columns that are not this rank's.
  using RowClass = std::tuple<int, int, int, int>;  // own column, at most reach; distances to the edges; k
  struct Tables {
    std::vector<FamilyRow<Real>> rows;
    std::vector<FamilyBond<Real>> bonds;
    std::vector<FamilyWord> words;
    std::vector<Real> interior;
    std::map<int, std::vector<Real>> ends;            // by block
    std::map<int, std::vector<std::uint16_t>> whole;  // by block near the ends
    std::vector<const Real*> end_of;                  // [block]
    std::vector<const std::uint16_t*> whole_of;       // [block]
  };
  class Builder;
  RowClass row_class(int jl, int k) const;

  int ny_, mirrored_columns_, j0_, layers_;
  std::map<RowClass, Tables> tables_;
  std::vector<FamilyTables<Real>> rows_;  // [column][layer]
};

}  // namespace icebow
