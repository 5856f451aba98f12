// The bonds of a particle of ice that hardly deforms, for the kernel's linear passes (kernel.h): the whole
// family of all particles of a column at once, ordered so that a neighbour is loaded once for all of them.
//
// With the law linearised in eta (docs/theory.md), and xi = dx (di, dj, dk) in whole numbers:
//   theta_k = sum_j W (di, dj, dk) . eta,   a_k = sum_j [B (di, dj, dk) . eta + A (theta_k + theta_j)] (di,
//   dj, dk)
// where eta = u_j - u_k. The parts of u_k and theta_k are summed beforehand: the own constants.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "solver/lattice/bond_weights.h"

namespace icebow {

// Columns of neighbours whose bonds reach the same number dk of layers up and down. A mirrored group's
// columns stand for themselves and for those at -di, whose weights are the same.
template <class Real>
struct LinearGroup {
  struct Column {
    std::ptrdiff_t offset,
        mirror;  // elements from a particle to its neighbour in the same layer, and to its image
    Real di, dj;
  };
  int dk;
  bool mirrored;
  std::vector<Column> columns;
};

constexpr int own_dilatation_constants = 3, own_force_constants = 9;

// Constants of one class of blocks: one number each, or one for each of the 16 particles of a block that is
// near the ends of the sheet.
template <class Real>
struct LinearWeights {
  const std::vector<LinearGroup<Real>>* groups = nullptr;
  // [group][column][layer of the neighbour][layer, where within dk]: W; B and A
  std::vector<Real> dilatation, force;
  // [layer][3]: sum of W xi. [layer][9]: sum of B xi xi (xx, yy, zz, xy, xz, yz), sum of A xi
  std::vector<Real> own_dilatation, own_force;
};

template <class Real>
class LinearTables {
 public:
  LinearTables(const Lattice& lattice, const Layout& layout, const Stencil& stencil, const Material& material,
               const BondTableOptions& options);

  // Of the owned block b of column jl.
  const LinearWeights<Real>& of(int jl, int b) const { return *at_[std::size_t(jl) * blocks_ + b]; }
  bool is_end(int b) const { return ends_[b]; }  // has constants for each particle

 private:
  using Class = std::tuple<int, int, int>;  // distances to the port and starboard edges, block or -1
  int blocks_;
  struct Groups {
    std::vector<LinearGroup<Real>> mirrored, single;
  };
  std::unique_ptr<const Groups> groups_;  // weights point at them
  std::map<Class, LinearWeights<Real>> weights_;
  std::vector<const LinearWeights<Real>*> at_;
  std::vector<bool> ends_;
};

}  // namespace icebow
