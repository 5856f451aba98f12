// The weights of one bond, volume and surface corrections included: docs/theory.md, eq. (3)-(9).
#pragma once

#include <map>
#include <tuple>

#include "solver/lattice/stencil.h"

namespace icebow {

// How many particles from an edge of the sheet it still matters: the factors of a bond end depend on edges
// within `reach`, and the other end lies within `reach` again.
constexpr int edge_influence = 2 * reach;

// The block whose first particle is i has the same bonds with the same weights at each of its particles.
inline bool is_interior(const Lattice& lattice, int i) {
  return i >= edge_influence && i + block - 1 <= lattice.nx - 1 - edge_influence;
}

struct BondTableOptions {
  bool surface_correction = true;
  double rho = 0.0;  //!< ice density [kg/m^3]
};

// theta_k += dilatation s; acceleration_k += (pressure (theta_k + theta_j) + distortion s) y/|y|, with one
// 1/L of y/|y| taken into the weights. All 0 where the bond does not exist.
struct BondWeight {
  double dilatation = 0.0, pressure = 0.0, distortion = 0.0;
};

class BondWeights {
 public:
  BondWeights(const Lattice& lattice, const Stencil& stencil, const Material& material,
              const BondTableOptions& options)
      : lattice_(lattice), stencil_(stencil), m_(material), options_(options) {}

  // Of the bond from particle (i, j, k) to (i, j, k) + offset, either of which may lie outside the sheet.
  BondWeight operator()(int i, int j, int k, const Offset& offset);

 private:
  bool exists(int i, int j) const {
    return i >= 0 && i < lattice_.nx && j >= -lattice_.mirrored_columns() && j < lattice_.ny;
  }
  const SurfaceFactors& factors(int i, int j, int k);

  const Lattice& lattice_;
  const Stencil& stencil_;
  const Material& m_;
  BondTableOptions options_;
  std::map<std::tuple<int, int, int, int, int>, SurfaceFactors> cache_;
};

}  // namespace icebow
