// One rank's part of the ice sheet: its fields, its bonds, and the passes over its rows.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "base/communicator.h"
#include "solver/kernel/bond_tables.h"
#include "solver/kernel/column_weights.h"
#include "solver/kernel/crush_watch.h"
#include "solver/kernel/families.h"
#include "solver/kernel/kernel.h"
#include "solver/kernel/linear_blocks.h"
#include "solver/kernel/linear_weights.h"
#include "solver/lattice/field.h"
#include "solver/lattice/lattice.h"
#include "solver/lattice/stencil.h"
#include "solver/model/scenario.h"

namespace icebow {

// Alive bonds, each once, at its lower end: one word of 16 particles for each block and column slot. Rows jl
// = -reach .. columns - 1 and blocks -1 .. blocks: a rank also follows the bonds that reach into its part.
class BondBits {
 public:
  BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil);
  // At block 0 of a row; blocks follow each other, each with the slots of all layers of the column.
  // Words of a slot of row j for the block whose first particle is i: bonds within the lattice.
  static std::uint16_t whole(const Lattice& lattice, const Offset& offset, int i, int j);
  std::uint16_t* row(int jl, int k) { return &words_[index(jl, 0, k)]; }
  const std::uint16_t* row(int jl, int k) const { return &words_[index(jl, 0, k)]; }
  int per_block() const { return per_block_; }
  std::int64_t count() const { return count(0, columns_); }  // alive bonds of this rank's own particles
  std::int64_t count(int jl0, int jl1) const;                // of own blocks in the columns [jl0, jl1)
  std::size_t bytes() const { return words_.size() * sizeof words_[0]; }

 private:
  std::size_t index(int jl, int b, int k) const {
    return (std::size_t(jl + reach) * (blocks_ + 2) + (b + 1)) * per_block_ + first_slot_[k];
  }
  int blocks_, columns_, per_block_;
  std::vector<int> first_slot_;
  std::vector<std::uint16_t> words_;
};

// Blocks of ice that follow the linear law, of all.
struct LinearCount {
  std::int64_t linear = 0, all = 0;
};

class IceSheet {
 public:
  // Another vector width than the widest is for tests.
  IceSheet(const Scenario& scenario, const Lattice& lattice, const Partition& partition,
           const Material& material, const Kernels& kernel = kernels());

  Lattice lattice;  // changed by drop_first_block() and start_at() alone
  const Partition partition;
  const Layout layout;
  const Stencil stencil;
  const Kernels& kernel;
  const Precision precision;

  Field u[3], v[3], residual[3], acceleration[3], theta;
  // Added, for both ends, to what a bond bears over its limit: 0, or one of these.
  Field extra_strength;
  static constexpr double held_together = 1e3, crushed = -1e9;
  // How deep the hull has crushed each particle [m], which grows; and the hull's face that presses it, as its
  // number plus 1, or 0.
  Field crushed_depth, touched_face;
  BondBits bits;

  // Passes in the order of a step, each over the columns [jl0, jl1) counted from the first owned one. Drift
  // and force may take them in any order, the dilatation takes them upwards. Both look at neighbours up to
  // `reach` columns away: at displacements, and the force at dilatations as well.
  void drift(const DriftSettings& settings, int jl0, int jl1);  // v += dt (bonds + g); u += dt v
  // Breaks bonds; returns how many of this rank's own did, a half model's counted in the whole sheet.
  std::int64_t dilatation(int jl0, int jl1);
  // The bonds' part of the acceleration; returns how many broke by their stress, counted likewise.
  std::int64_t force(int jl0, int jl1);

  // Which blocks are cracked, by their bonds: after these have been changed from outside the passes.
  void find_cracks();

  // Whole passes.
  void drift(const DriftSettings& settings) { drift(settings, 0, layout.columns); }
  std::int64_t dilatation() { return dilatation(0, layout.columns); }
  std::int64_t force() { return force(0, layout.columns); }

  // Falls whenever a bond of a particle of an own block of all layers breaks.
  std::int64_t bond_mark(int jl, int b) const;

  // The lowest column whose bonds reach into this rank's part.
  int first_column() const { return partition.south >= 0 || lattice.half ? -reach : 0; }

  // Half model: whether the columns below the own ones are mirror images (solver/ice/mirror.h). Their bonds
  // to own columns are all that cross the plane, each of the whole sheet once.
  bool at_symmetry_plane() const { return lattice.half && partition.south < 0; }
  // Alive bonds of this rank's own particles, in the whole sheet.
  std::int64_t bonds() const {
    return lattice.copies() * bits.count() + (at_symmetry_plane() ? bits.count(-reach, 0) : 0);
  }

  // The window moves by a block along x (solver/ice/moving_window.cpp): block 0 of the lattice is dropped,
  // one of fresh ice at rest is laid at the other end. Collective. Ghosts of the fields are out of date
  // afterwards.
  void drop_first_block(const Communicator& comm);
  // The window has left so many particles astern.
  void start_at(int first);

  // Of the own blocks, those that took the linear passes in the last step.
  LinearCount linear_blocks() const;
  double linear_share() const {
    const LinearCount n = linear_blocks();
    return double(n.linear) / double(n.all);
  }
  bool is_linear(int jl, int b) const;  // likewise

  // Of the own blocks of a row, Real being of the sheet's precision: DriftRow::travelled2 of the last drift.
  template <class Real>
  const Real* travelled2(int jl, int k) const {
    return &std::get<Work<Real>>(work_).travelled2[(std::size_t(jl) * layout.nz + k) * layout.blocks];
  }
  bool held(int i, int j) const;  // fixed edge
  bool mobile(int jl, int local_i) const {
    return !held(layout.i0 + local_i, layout.j0 + jl) && layout.i0 + local_i < lattice.nx;
  }

  // BlockLaw and `cracked` of the blocks -1 .. blocks of a row; rows jl = -reach .. columns - 1, of which the
  // own ones count.
  std::uint8_t* state(int jl, int k) {
    return &state_[(std::size_t(jl + reach) * layout.nz + k) * (layout.blocks + 2) + 1];
  }
  const std::uint8_t* state(int jl, int k) const { return const_cast<IceSheet*>(this)->state(jl, k); }

  // Bonds' constants; Real must be of the sheet's precision.
  template <class Real>
  const BondTables<Real>& tables() const {
    return std::get<Work<Real>>(work_).tables;
  }

  std::size_t bytes() const;  // of everything that grows with the number of particles

 private:
  // What the passes need in one precision.
  template <class Real>
  struct Work {
    BondLaw<Real> law;
    BondTables<Real> tables;
    Families<Real> families;
    ColumnTables<Real> at_once;
    CrushWatch<Real> crushed;
    std::vector<RowFields<Real>> fields;  // of the current column, by layer
    std::vector<Real> mobile_x, nothing_mobile;
    std::vector<Real> travelled2;  // DriftRow, [column][layer][block]
    std::vector<Real> strain;      // ColumnFields, [column][block][16]
    LinearTables<Real> linear_tables;
    LinearBlocks<Real> linear;
    std::vector<std::uint8_t> none;  // [block]: 0
    Real safe_theta;                 // up to which no bond of a linear block is near its stress
  };
  template <class Real>
  Work<Real> make_work(const Scenario& scenario, const Material& material) const;
  std::variant<Work<float>, Work<double>> make_work(const Scenario& scenario, const Material& material) const;
  template <class Real>
  void drift_column(Work<Real>& work, const DriftSettings& settings, int jl);
  template <class Real>
  void select_column(Work<Real>& work, int jl, const std::uint8_t* crush);
  template <class Real>
  RowFields<Real> fields(const Work<Real>& work, int jl, int k, const std::uint8_t* crush);
  template <class Real>
  LinearFields<Real> linear_fields(int jl);
  template <class Real>
  ColumnFields<Real> column_fields(Work<Real>& work, int jl);
  template <class Real>
  typename LinearBlocks<Real>::Ice ice(int jl, const std::uint8_t* crush);
  template <class Real>
  Broken dilate_column(Work<Real>& work, int jl);
  template <class Real>
  Broken force_column(Work<Real>& work, int jl);
  std::int64_t in_whole_sheet(const Broken& broken) const {
    return lattice.copies() * broken.own + broken.image;
  }
  void shift_fields(const Communicator& comm);
  void hold_far_end_together();
  void shift_bonds(const Communicator& comm);
  void mend_bonds(int jl);
  template <class Real>
  const Passes<Real>& passes_of(const Work<Real>&) const {
    return kernel.passes<Real>();
  }

  bool sides_held_, far_end_held_;
  std::variant<Work<float>, Work<double>> work_;
  std::uint16_t* bonds_there(int jl) { return &there_[std::size_t(jl) * layout.blocks * bonds_there_]; }

  std::vector<std::uint16_t> there_;  // RowFields::there of the own columns
  int bonds_there_ = 0;               // of a block
  std::vector<std::uint8_t> state_;   // ghost rows and blocks included
};

}  // namespace icebow
