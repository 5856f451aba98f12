// The weights of every bond of the sheet, by class: volume and surface corrections cost nothing in a step.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "solver/kernel/kernel.h"
#include "solver/lattice/bond_weights.h"

namespace icebow {

template <class Real>
class BondTables {
 public:
  BondTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil, const Material& material,
             const BondTableOptions& options);

  // Tables of row (jl, k), jl = -reach .. columns - 1 counted from the first owned column.
  RowTables<Real> row(int jl, int k) const;

 private:
  // Rows whose distances to the port and starboard edges are equal (beyond twice the reach: both far) share
  // tables.
  // Below the symmetry plane of a half model each column has its own: bonds that do not cross have no weight.
  using RowClass = std::tuple<int, int, int>;  // distance to the low edge, to j = ny - 1, k
  struct Tables {
    std::vector<Real> interior;
    std::map<int, std::vector<Real>> ends;  // by block
    std::vector<const Real*> end_of;  // [1 + block], ghost blocks included: what RowTables::ends points at
  };
  RowClass row_class(int jl, int k) const;

  int ny_, mirrored_columns_, j0_;
  std::vector<std::vector<std::ptrdiff_t>> neighbour_;  // [k][slot]
  std::map<RowClass, Tables> tables_;
};

}  // namespace icebow
