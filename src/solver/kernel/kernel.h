// The bond passes and the time integration over rows of the lattice, in SIMD.
//
// One source (kernel_impl.h) is compiled for several vector widths and for fp32 and fp64; kernels() picks the
// widest this processor has. A particle's whole family is summed in registers and stored: nothing is added to
// neighbours, so each block of 16 particles is on its own, and its sums have the same terms in the same order
// on any number of ranks. Both ends of a bond do the same arithmetic on the same operands, but for signs:
// they find the same force, and break the bond in the same step, wherever they are owned.
//
// Law of a bond (docs/theory.md, eq. 10-12), with q = 2 xi.eta + eta.eta and e = q / L^2:
//   stretch s = sqrt(1 + e) - 1 = e G(e),  1/|y| = R(e) / L,  s/|y| = e H(e) / L
// G, R, H are polynomials fitted when the run starts (no root, no division, no cancellation). Which ones a
// block of a row takes follows from the largest |e| of its bonds:
//   calm    |e| <= e_calm: series of G, R, H at e = 0, in fp32 of two terms (exact to 1e-6), in fp64 of three
//           (1e-9). One term would do for the force, but not for its being the same at both ends of a bond
//           whose ends follow different laws
//   bent    |e| <= e_small: fits of a low degree
//   wide    fits on [e_min, e_max]; beyond (a shortening of 10 %) they stay at their value there
// All layers of a block follow the same one. Calm and bent blocks are summed for all layers at once
// (column_weights.h), wide ones row by row.
// A block is cracked where a bond of one of its particles is broken: only then, and near the edges of the
// sheet, bond bits are looked at. Whether a bond breaks is asked once for a block: by its largest e; or by
// what that and the largest theta around allow its stresses to be at most, and where these may be too high by
// the largest stress. Only where that is beyond the limit, bonds are looked at one by one, and the block is
// summed again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "solver/kernel/floe_forces.h"
#include "solver/kernel/water_columns.h"
#include "solver/lattice/stencil.h"

namespace icebow {

// Of a block of a row: which law it follows, and whether it is cracked.
enum BlockLaw : std::uint8_t { calm, bent, wide };
constexpr std::uint8_t law_bits = 3, cracked = 4;
inline BlockLaw law_of(std::uint8_t state) {
  return static_cast<BlockLaw>(state & law_bits);
}

template <class Real>
struct LawDegrees;
template <>
struct LawDegrees<float> {
  static constexpr int calm = 1, small = 2, wide = 5;
};
template <>
struct LawDegrees<double> {
  static constexpr int calm = 2, small = 4, wide = 12;
};
constexpr double calm_strain = 1e-3;    // |e| of a calm block at most
constexpr double bent_strain = 0.0125;  // where the short fits are still as good as the wide ones

// Coefficients of e^0, e^1, ...
template <class Real, int degree>
struct LawFits {
  Real G[degree + 1], R[degree + 1], H[degree + 1];
};

// G and H over their value 1/2 at e = 0, which is in the weights.
template <class Real>
struct BondLaw {
  LawFits<Real, LawDegrees<Real>::wide> wide;    // on [e_min, e_max]
  LawFits<Real, LawDegrees<Real>::small> small;  // on [-e_small, e_small]
  LawFits<Real, LawDegrees<Real>::calm> calm;    // series at 0
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

// Constants of a bond's slot:
//   theta += dilatation * s; acceleration += (pressure (theta_k + theta_j) + distortion s) y/|y|
// with 1/L taken out of y/|y|. The weights hold volume and surface corrections, the bond constants and the
// density; they are 0 where the sheet ends before the bond does.
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

// A row's view of the tables of its bonds to higher ends, each bond once. Interior blocks share one; a block
// near the ends of the sheet has constants for each of its particles.
template <class Real>
struct RowTables {
  int n_slots;
  const std::ptrdiff_t* neighbour;  // [slot]: elements from a particle to its neighbour
  const Real* interior;             // [slot][constant]
  const Real* const* ends;          // [block]: [slot][constant][16], or nullptr where the block is interior
};

// A bond of a particle's whole family, the same for a row's particles.
template <class Real>
struct FamilyBond {
  std::ptrdiff_t neighbour;  // elements from a particle to the other end
  Real xi_x, inverse_L2;     //!< [m], [1/m^2]
};
// Bonds to one row of neighbours: they follow each other, and have these components in common.
template <class Real>
struct FamilyRow {
  int bonds;
  Real xi_y, xi_z;  //!< [m]
};
// Where a bond's bits lie.
struct FamilyWord {
  std::ptrdiff_t word;  // from the block's words to those of the bond's lower ends in the same block
  int shift;        // of the words before, of and after that block, taken as one number: own bits come last
  bool own, image;  // the lower end is in a column of this rank's, or the mirror image of one
  int place;        // of the bond among those of the column (column_weights.h)
};

// Weights of a bond, those of G and H halved (BondLaw), in the order of use.
constexpr int family_weights = 3;
enum FamilyWeight { half_dilatation, pressure, half_distortion };

// A row's families: all bonds that end in the sheet.
template <class Real>
struct FamilyTables {
  int rows, bonds;
  const FamilyRow<Real>* row;
  const FamilyBond<Real>* bond;
  const FamilyWord* word;
  const Real* interior;               // [bond][weight]
  const Real* const* ends;            // [block]: [bond][weight][16], or nullptr where the block is interior
  const std::uint16_t* const* whole;  // [block]: [bond]: bonds that are in the sheet, likewise
};

// Alive bonds of a block's 16 particles, by the words of their lower ends in the block and those beside it.
inline unsigned alive(const std::uint16_t* words, int per_block, int shift) {
  const std::uint64_t all =
      words[-per_block] | std::uint64_t(words[0]) << 16 | std::uint64_t(words[per_block]) << 32;
  return static_cast<unsigned>(all >> shift) & 0xffffu;
}

template <class Real>
struct RowFields {
  const Real* u[3];            // displacement [m], at the row's first owned particle
  const Real* extra_strength;  // of each particle: IceSheet::extra_strength
  Real* acceleration[3];       // out, from bonds [m/s^2]
  Real* theta;                 // out, dilatation
  std::uint16_t* bits;         // [block][column slot]: alive bonds of 16 particles, each at its lower end
  int bits_per_block;          // column slots
  // [block][place]: alive bonds of 16 particles of all layers, as the bits have them (column_weights.h)
  std::uint16_t* there;
  int there_per_block;
  int blocks;                  // owned ones
  std::uint8_t* state;         // [block]: BlockLaw and `cracked`
  const std::uint8_t* linear;  // [block]: 1 where the linear passes do it all
  const std::uint8_t* crush;   // [block]: 1 where a particle within reach has been crushed in this step
};

// Bonds that broke: of own lower ends, and of lower ends that are mirror images of own particles.
struct Broken {
  int own = 0, image = 0;
};

// Weight and buoyancy of the drift, and from where it is looked at.
struct DriftSettings {
  double dt;          //!< [s]
  double gravity;     //!< [m/s^2]; 0 = no weight
  double lift;        //!< (rho_w/rho) g [m/s^2]
  double inverse_dx;  //!< [1/m]
  double V;           //!< of the hull, along x [m/s]
};

template <class Real>
struct DriftRow {
  Real* u[3];
  Real* v[3];
  Real* residual[3];            // of the compensated sum of u
  const Real* acceleration[3];  // from bonds
  const Real* mobile;           // 1, or 0 for particles that are held or do not exist
  Real z;                       // reference z of the row [m]
  Real* travelled2;  // out, per block: squared way of the fastest particle in the hull's frame [m^2]
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
template <class Real>
struct ColumnWeights;

// What the passes know about a column besides its rows.
template <class Real>
struct ColumnFields {
  LinearFields<Real> fields;
  const ColumnWeights<Real>* const*
      weights[2];  // calm, bent: [block]; no array: more than most_linear_layers
  Real* strain;    // [block][16]: what e of the block's bonds is at most, vectors of the kernel's width
};

// Of block b of all layers.
template <class Real>
struct LinearPasses {
  using Pass = void (*)(const LinearFields<Real>&, const LinearWeights<Real>&, int b);
  // Returns the largest theta of the particles and their neighbours.
  using ForcePass = Real (*)(const LinearFields<Real>&, const LinearWeights<Real>&, int b);
  Pass theta, theta_at_end;  // the latter with constants for each particle
  ForcePass force, force_at_end;
};
constexpr int most_linear_layers = 5;

// What is known of a block of a column: nearest neighbours displaced alike along x and z, and from it to the
// next column.
enum Flatness : std::uint8_t { flat_within = 1, flat_across = 2 };

template <class Real>
struct Passes {
  // For the nz rows of a column: theta of all blocks that are not linear. Breaks bonds by their stretch, and
  // follows the blocks' states.
  Broken (*dilatation)(const ColumnFields<Real>&, const RowFields<Real>*, const FamilyTables<Real>*, int nz,
                       const BondLaw<Real>&);
  // Their acceleration. Breaks bonds by their stress.
  Broken (*force)(const ColumnFields<Real>&, const RowFields<Real>*, const FamilyTables<Real>*, int nz,
                  const BondLaw<Real>&);
  // Of a column's block that has taken the linear passes, and in which bonds may be near their stress: breaks
  // those, and then does the block anew.
  Broken (*look_closer)(const ColumnFields<Real>&, const RowFields<Real>*, const FamilyTables<Real>*, int nz,
                        const BondLaw<Real>&, int b);
  // Bits of the numbers below 0, 16 numbers a word.
  void (*negative)(const Real* numbers, int words, std::uint16_t* bits);
  // v += dt * (bonds + weight and lift); u += dt v.
  void (*drift)(const DriftRow<Real>&, const DriftSettings&);
  // Of the columns of a block, of which `mobile` has a bit each: what the water does to them. Strikes may be
  // none.
  void (*water_columns)(const WaterFields<Real>&, const WaterLaw&, unsigned mobile,
                        const WaterStrikes* strikes, WaterColumns& out);
  // Adds it to their accelerations; returns the energy that the water takes [J].
  double (*water_push)(const WaterFields<Real>&, const WaterLaw&, const WaterColumns&);
  LinearPasses<Real> linear[most_linear_layers];  // [layers - 1]
  // Flatness of block b and a bond's reach beyond it: squared displacement differences of nearest neighbours
  // up to the limit [m^2]. has_next is 1 where a particle and the next along x exist, else 0. A block that is
  // not flat within is not looked at further.
  std::uint8_t (*flatness)(const LinearFields<Real>&, int nz, int b, const Real* has_next, Real limit);
};

// Two particles of two blocks: layer * block + lane.
struct NearPair {
  std::uint16_t a, b;
};
// Particles of a block's columns: places by [layer][x, y, z][lane], and the box they lie in [m].
struct NearBlock {
  const float* places;
  const float *lower, *upper;
};

struct Kernels {
  const char* name;  // "avx512", "avx2", "baseline"
  int vector_bytes;
  Passes<float> fp32;
  Passes<double> fp64;
  // Particles of two blocks' columns of which the squared distance is less; each pair once where both are the
  // same block. `out` has room for all pairs; returns how many there are.
  int (*near_pairs)(const NearBlock& a, const NearBlock& b, int layers, float within2, bool same,
                    NearPair* out);
  // per_force: quanta of a newton; forces are less than 2^51 of them.
  void (*floe_forces)(const FloeContactLaw&, const FloeTouches&, double per_force);

  template <class Real>
  const Passes<Real>& passes() const {
    if constexpr (sizeof(Real) == sizeof(float)) {
      return fp32;
    } else {
      return fp64;
    }
  }
};

// The widest this processor runs, or what the environment variable ICEBOW_KERNEL names. Throws InputError
// where that is not known, or not for this processor.
const Kernels& kernels();
const Kernels& kernels_named(const std::string& name);  // empty = the widest
const Kernels& baseline_kernels();                      // for tests

}  // namespace icebow
