// The bond passes and the time integration over rows of the lattice, in SIMD.
//
// One source (kernel_impl.h) is compiled for several vector widths and for fp32 and fp64; kernels() picks the
// widest this processor has. Each bond is computed once, by the row of its lower end, which adds the reaction
// to the neighbour's row. Within a column, blocks go from low to high x and layers upwards, the copies of
// neighbouring ranks' blocks included; columns are taken in the order the caller asks for, the same on any
// number of ranks. So every sum has the same terms in the same order on any number of ranks.
//
// Law of a bond (docs/theory.md, eq. 10-12), with q = 2 xi.eta + eta.eta and e = q / L^2:
//   stretch s = sqrt(1 + e) - 1 = e G(e),  1/|y| = R(e) / L,  s/|y| = e H(e) / L
// G, R, H are polynomials fitted when the run starts (no root, no division, no cancellation). What a block
// of 16 particles needs depends on its state:
//   calm     all bonds there, |e| <= e_calm: series of G, R, H at e = 0; in fp32 their first term alone
//            (relative error of a force below 0.75 e_calm), in fp64 three terms (below 1e-9)
//   intact   all bonds there, |e| <= e_small: fits of a low degree, no bond bits
//   touched  some bond broken or stretched further: bond bits, fits on [e_min, e_max]; beyond (a
//            shortening of 10 %) they stay at their value there. Where bonds break by stress, back to
//            intact once they have slackened and all are there
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/lattice/stencil.h"

namespace icebow {

enum BlockState : std::uint8_t { calm, intact, touched };

template <class Real>
struct LawDegrees;
template <>
struct LawDegrees<float> {
  static constexpr int calm = 0, small = 2, wide = 5;
};
template <>
struct LawDegrees<double> {
  static constexpr int calm = 2, small = 4, wide = 12;
};
constexpr double calm_strain = 1e-3;  // e of a calm block at most

// Coefficients of e^0, e^1, ...
template <class Real, int degree>
struct LawFits {
  Real G[degree + 1], R[degree + 1], H[degree + 1];
};

template <class Real>
struct BondLaw {
  LawFits<Real, LawDegrees<Real>::wide> wide;    // on [e_min, e_max]
  LawFits<Real, LawDegrees<Real>::small> small;  // on [-e_small, e_small], where no bond can break
  LawFits<Real, LawDegrees<Real>::calm> calm;    // series at 0, divided by their first terms
  Real e_calm;
  Real e_small;
  Real e_min, e_max;  // ends of the fits
  // The bond breaks in the dilatation pass above (1 + s0)^2 - 1; no limit where its stress decides.
  Real e_break;
  // It breaks in the force pass where stress_per_stretch s + stress_per_theta (theta_k + theta_j) is above 1;
  // both 0 where its stretch decides.
  Real stress_per_stretch, stress_per_theta;
};

// Fits G, R, H; relative error below 2e-6 in fp32, 2e-11 in fp64 (tests/solver/kernel/kernel_test.cpp).
template <class Real>
BondLaw<Real> make_bond_law(const Material& material);

// Constants of a slot:
//   theta += dilatation * s; acceleration += (pressure (theta_k + theta_j) + distortion s) y/|y|
// with 1/L taken out of y/|y|. The weights hold volume and surface corrections, the bond constants and the
// density; they are 0 where the sheet ends before the bond does. In the order of use by calm blocks.
enum SlotConstant {
  xi2_x,  //!< twice the reference bond [m]
  xi2_y,
  xi2_z,
  calm_dilatation,  // dilatation G(0) / L^2
  xi_x,             //!< reference bond [m]
  xi_y,
  xi_z,
  pressure_weight,
  calm_distortion,  // distortion H(0) / L^2
  inverse_L2,       //!< 1/L^2 [1/m^2]
  dilatation_weight,
  distortion_weight,
  constants_per_slot
};

// A row's view of its tables. Interior blocks share one; a block near the ends of the sheet has constants for
// each of its particles.
template <class Real>
struct RowTables {
  int n_slots;
  const std::ptrdiff_t* neighbour;  // [slot]: elements from a particle to its neighbour
  const Real* interior;             // [slot][constant]
  const Real* const* ends;          // [block]: [slot][constant][16], or nullptr where the block is interior
  Real theta_per_strain;            // the least a bond adds to theta, over e
};

template <class Real>
struct RowFields {
  const Real* u[3];             // displacement [m], at the row's first owned particle
  const Real* extra_strength;   // of each particle: IceSheet::extra_strength
  Real* acceleration[3];        // from bonds [m/s^2]
  Real* theta;                  // dilatation
  std::uint16_t* bits;          // [block][column slot]: alive bonds of 16 particles
  int bits_per_block;           // column slots
  std::uint8_t* state;          // [block]: BlockState
  const std::uint8_t* skip;     // [block]: 1 where the linear passes do all that matters
  int first_block, last_block;  // blocks [first_block, last_block), -1 and `blocks` being ghosts
};

// Weight, buoyancy and box test of the drift.
struct DriftSettings {
  double dt;                    //!< [s]
  double gravity;               //!< [m/s^2]; 0 = no weight
  double lift;                  //!< (rho_w/rho) g [m/s^2]
  double inverse_dx;            //!< [1/m]
  double box_lo[3], box_hi[3];  // hull's bounding box [m]
};

template <class Real>
struct DriftRow {
  Real* u[3];
  Real* v[3];
  Real* residual[3];        // of the compensated sum of u
  Real* acceleration[3];    // from bonds; used up: zero afterwards
  Real* theta;              // zero afterwards, for the next dilatation pass
  const Real* x;            // reference x of each particle [m]
  const Real* mobile;       // 1, or 0 for particles that are held or do not exist
  Real y, z;                // reference y, z of the row [m]
  std::uint8_t* near_hull;  // out, per block: some particle lies in the box
  int blocks;
};

// Columns of particles for the linear passes: rows of the lowest layer at block 0 of a column.
template <class Real>
struct LinearFields {
  const Real* u[3];
  Real* theta;
  Real* acceleration[3];
  std::ptrdiff_t layer, column;  // elements to the layer above, to the next column
};

template <class Real>
struct LinearWeights;

// Of block b of all layers. Unlike the passes over bonds these sum the whole family of each particle, and
// store.
template <class Real>
struct LinearPasses {
  using Pass = void (*)(const LinearFields<Real>&, const LinearWeights<Real>&, int b);
  Pass theta, theta_at_end, force, force_at_end;  // the latter with constants for each particle
};
constexpr int most_linear_layers = 5;

// Largest sums of squared displacement differences of nearest neighbours [m^2].
template <class Real>
struct Roughness {
  Real within, across;  // along x and z; to the next column
};

template <class Real>
struct Passes {
  // For the nz rows of a column. Adds their bonds to theta of both ends; breaks bonds first and returns how
  // many of owned blocks' broke. Follows the blocks' states.
  int (*dilatation)(const RowFields<Real>*, const RowTables<Real>*, int nz, const BondLaw<Real>&,
                    int owned_blocks);
  // Adds their bonds to the acceleration of both ends; breaks those whose stress is too high and returns how
  // many of owned blocks' did.
  int (*force)(const RowFields<Real>*, const RowTables<Real>*, int nz, const BondLaw<Real>&,
               int owned_blocks);
  // v += dt * (bonds + weight and lift); u += dt v.
  void (*drift)(const DriftRow<Real>&, const DriftSettings&);
  LinearPasses<Real> linear[most_linear_layers];  // [layers - 1]
  // Of block b and a bond's reach beyond it; has_next is 1 where a particle and the next along x exist, else
  // 0.
  Roughness<Real> (*roughness)(const LinearFields<Real>&, int nz, int b, const Real* has_next);
};

struct Kernels {
  const char* name;  // "avx512", "avx2", "baseline"
  int vector_bytes;
  Passes<float> fp32;
  Passes<double> fp64;

  template <class Real>
  const Passes<Real>& passes() const {
    if constexpr (sizeof(Real) == sizeof(float)) {
      return fp32;
    } else {
      return fp64;
    }
  }
};

const Kernels& kernels();           // the widest this processor runs
const Kernels& baseline_kernels();  // for tests

}  // namespace icebow
