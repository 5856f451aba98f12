// The two bond passes and the time integration over rows of the lattice, in SIMD.
//
// One source (kernel_impl.h) is compiled for several vector widths; kernels() picks the widest this processor
// has. Each bond is computed once, by the row of its lower end, which adds the reaction to the neighbour's
// row. Rows are taken in the order of (j, k) and blocks from low to high x, the copies of neighbouring ranks'
// columns and blocks included, so every sum has the same terms in the same order on any number of ranks.
//
// Law of a bond (docs/theory.md, eq. 10-12), with q = 2 xi.eta + eta.eta and e = q / L^2:
//   stretch s = sqrt(1 + e) - 1 = e G(e),  1/|y| = R(e) / L,  s/|y| = e H(e) / L
// G, R, H are polynomials fitted when the run starts (no root, no division, no cancellation); below e_min (a
// shortening of 10 %) they stay at their value there. A block of particles none of whose bonds is broken,
// missing or stretched or shortened by more than e_small takes a shorter path without bond bits, with fits of
// degree 2.
#pragma once

#include <cstddef>
#include <cstdint>

namespace icebow {

constexpr int law_degree = 5, small_law_degree = 2;

// Coefficients of e^0, e^1, ...
template <int degree>
struct LawFits {
  float G[degree + 1], R[degree + 1], H[degree + 1];
};

struct BondLaw {
  LawFits<law_degree> wide;         // on [e_min, e_break]
  LawFits<small_law_degree> small;  // on [-e_small, e_small], e_small <= e_break
  float e_small;
  float e_min;    // lower end of the fits
  float e_break;  // (1 + s0)^2 - 1: the bond breaks above
};

// Fits G, R, H; relative error below 2e-6 (tests/solver/kernel_test.cpp).
BondLaw make_bond_law(double critical_stretch);

// Constants of a slot:
//   theta += dilatation * s; acceleration += (pressure (theta_k + theta_j) + distortion s) y/|y|
// with 1/L taken out of y/|y|. The weights hold volume and surface corrections, the bond constants and the
// density.
enum SlotConstant {
  xi_x,  //!< reference bond [m]
  xi_y,
  xi_z,
  inverse_L2,  //!< 1/L^2 [1/m^2]
  dilatation_weight,
  pressure_weight,
  distortion_weight,
  constants_per_slot
};

// A row's view of its tables. Interior blocks share one; a block near the ends of the sheet has constants for
// each of its particles.
struct RowTables {
  int n_slots;
  const std::ptrdiff_t* neighbour;  // [slot]: floats from a particle to its neighbour
  const float* interior;            // [slot][constant]
  const float* const* ends;         // [block]: [slot][constant][16], or nullptr where the block is interior
};

struct RowFields {
  const float* u[3];            // displacement [m], at the row's first owned particle
  float* acceleration[3];       // from bonds [m/s^2]
  float* theta;                 // dilatation
  std::uint16_t* bits;          // [block][column slot]: alive bonds of 16 particles
  int bits_per_block;           // column slots
  std::uint8_t* touched;        // [block]: some bond of the block is broken, missing or strongly stretched
  int first_block, last_block;  // blocks [first_block, last_block), -1 and `blocks` being ghosts
};

// Weight, buoyancy and box test of the drift.
struct DriftSettings {
  float dt;                    //!< [s]
  float gravity;               //!< [m/s^2]; 0 = no weight
  float lift;                  //!< (rho_w/rho) g [m/s^2]
  float inverse_dx;            //!< [1/m]
  float box_lo[3], box_hi[3];  // hull's bounding box [m]
};

struct DriftRow {
  float* u[3];
  float* v[3];
  float* residual[3];       // of the compensated sum of u
  float* acceleration[3];   // from bonds; used up: zero afterwards
  float* theta;             // zero afterwards, for the next dilatation pass
  const float* x;           // reference x of each particle [m]
  const float* mobile;      // 1, or 0 for particles that are held or do not exist
  float y, z;               // reference y, z of the row [m]
  std::uint8_t* near_hull;  // out, per block: some particle lies in the box
  int blocks;
};

struct Kernels {
  const char* name;  // "avx512", "avx2", "baseline"
  int lanes;
  // For the nz rows of a column. Adds their bonds to theta of both ends; breaks bonds first and returns how
  // many of owned blocks' broke.
  int (*dilatation)(const RowFields*, const RowTables*, int nz, const BondLaw&, int owned_blocks);
  // Adds their bonds to the acceleration of both ends.
  void (*force)(const RowFields*, const RowTables*, int nz, const BondLaw&);
  // v += dt * (bonds + weight and lift); u += dt v.
  void (*drift)(const DriftRow&, const DriftSettings&);
};

const Kernels& kernels();           // the widest this processor runs
const Kernels& baseline_kernels();  // for tests

}  // namespace icebow
