// The bonds of calm and bent blocks (kernel.h), of all layers of a column at once: a neighbour is loaded once
// for all particles above each other that are bonded to it, and their sums, independent of each other, fill
// the processor's pipes. The law is not shortened for it.
//
// A column's bonds are numbered in the order of the passes: their places. The bits of a block's alive bonds
// (RowFields::there) are kept in this order.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "solver/kernel/kernel.h"
#include "solver/lattice/bond_weights.h"

namespace icebow {

// Columns of neighbours, of which a layer m is bonded to the layers l of the column with |m - l| <= dk.
template <class Real>
struct ColumnGroup {
  struct Column {
    int di, dj;
    std::ptrdiff_t offset;  // elements from a particle to its neighbour in the same layer
    Real xi_x, xi_y;        //!< [m]
  };
  int dk;
  bool own;  // the column itself: its particles have no bond to themselves
  std::vector<Column> columns;
};

template <class Real>
std::vector<ColumnGroup<Real>> column_groups(const Layout& layout, const Stencil& stencil, double dx);

// Calls visit(column, l, m) for all bonds, in the order of their places: from layer l to layer m of another
// column.
template <class Real, class Visit>
void for_column_bonds(const std::vector<ColumnGroup<Real>>& groups, int nz, Visit visit) {
  for (const auto& g : groups)
    for (const auto& column : g.columns)
      for (int m = 0; m < nz; ++m)
        for (int l = 0; l < nz; ++l)
          if (l - m <= g.dk && m - l <= g.dk && !(g.own && l == m)) visit(column, l, m);
}

// Place of a bond by its layer and offset: k, di, dj, dk.
using ColumnPlaces = std::map<std::array<int, 4>, int>;
ColumnPlaces column_places(const Layout& layout, const Stencil& stencil);

// Constants of a class of blocks in the order of use. With q = 2 xi.eta + eta.eta and the series G, R, H of
// the law, powers of 1/L^2 taken in, for each bond:
//   dilatation  1/L^2, W G, the highest power first
//   force       A R of power 0; B H of the highest power; then R, over that of power 0, and B H of the lower
//   ones
// W, A, B: weights of theta, of the pressure and of the distortion. Near the ends of the sheet these are
// numbers of each of the 16 particles, in lists of their own, and the series follow without them: 1/L^2, G;
// R, H.
template <class Real>
struct ColumnWeights {
  const std::vector<ColumnGroup<Real>>* groups = nullptr;
  Real dx = 0;  //!< [m]
  bool per_lane = false;
  bool masked = false;  // bonds end outside the sheet: bits are always looked at
  std::vector<Real> dilatation, dilatation_lanes, force, force_lanes;
};

template <class Real>
class ColumnTables {
 public:
  ColumnTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil, const Material& material,
               const BondTableOptions& options, const BondLaw<Real>& law);

  // Of the owned blocks of column jl, for a law that is calm or bent.
  const ColumnWeights<Real>* const* of(BlockLaw law, int jl) const {
    return &at_[law][std::size_t(jl) * blocks_];
  }

 private:
  using Class = std::tuple<int, int, int>;  // distances to the port and starboard edges, block or -1
  int blocks_;
  std::unique_ptr<const std::vector<ColumnGroup<Real>>> groups_;  // weights point at them
  std::map<Class, std::array<ColumnWeights<Real>, 2>> weights_;
  std::array<std::vector<const ColumnWeights<Real>*>, 2> at_;
};

}  // namespace icebow
