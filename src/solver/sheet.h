// One rank's part of the ice sheet: its fields, its bonds, and the passes over its rows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/bond_tables.h"
#include "solver/kernel.h"
#include "solver/lattice.h"
#include "solver/scenario.h"
#include "solver/stencil.h"

namespace icebow {

// Zeroed floats on a cache-line boundary. Fields that are walked together take different `stagger`s: arrays
// that all start at the same place of a page would compete for the same few cache sets.
class Field {
 public:
  explicit Field(std::size_t n, int stagger = 0);
  float* data() const { return data_; }
  float& operator[](std::size_t i) const { return data_[i]; }

 private:
  struct Free {
    void operator()(float* p) const;
  };
  std::unique_ptr<float[], Free> memory_;
  float* data_;
};

// Alive bonds, each once, at its lower end: one word of 16 particles for each block and column slot. Rows jl
// = -reach .. columns - 1 and blocks -1 .. blocks: a rank also follows the bonds that reach into its part.
class BondBits {
 public:
  BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil);
  // At block 0 of a row; blocks follow each other, each with the slots of all layers of the column.
  std::uint16_t* row(int jl, int k) { return &words_[index(jl, 0, k)]; }
  const std::uint16_t* row(int jl, int k) const { return &words_[index(jl, 0, k)]; }
  int per_block() const { return per_block_; }
  std::int64_t count() const;  // alive bonds of this rank's own particles
  std::size_t bytes() const { return words_.size() * sizeof words_[0]; }

 private:
  std::size_t index(int jl, int b, int k) const {
    return (std::size_t(jl + reach) * (blocks_ + 2) + (b + 1)) * per_block_ + first_slot_[k];
  }
  int blocks_, columns_, per_block_;
  std::vector<int> first_slot_;
  std::vector<std::uint16_t> words_;
};

class IceSheet {
 public:
  // Another vector width than the widest is for tests.
  IceSheet(const Scenario& scenario, const Lattice& lattice, const Partition& partition,
           const Material& material, const Kernels& kernel = kernels());

  const Lattice lattice;
  const Partition partition;
  const Layout layout;
  const Stencil stencil;
  const Kernels& kernel;

  Field u[3], v[3], residual[3], acceleration[3], theta;
  BondBits bits;

  // Passes in the order of a step. `settings.box_*` is where the hull may be.
  void drift(const DriftSettings& settings);    // v += dt (bonds + g); u += dt v; finds blocks near the hull
  std::int64_t dilatation(const BondLaw& law);  // breaks bonds; returns how many of this rank's own did
  void force(const BondLaw& law);               // the bonds' part of the acceleration

  bool near_hull(int jl, int k, int b) const {
    return near_hull_[(std::size_t(jl) * layout.nz + k) * layout.blocks + b];
  }
  bool held(int i, int j) const;  // fixed edge
  bool mobile(int jl, int local_i) const {
    return !held(layout.i0 + local_i, layout.j0 + jl) && layout.i0 + local_i < lattice.nx;
  }
  // At block 0 of a row, rows and blocks as of BondBits; see RowFields.
  std::uint8_t* touched(int jl, int k) { return &touched_[touched_index(jl, k)]; }
  const std::uint8_t* touched(int jl, int k) const { return &touched_[touched_index(jl, k)]; }

 private:
  std::size_t touched_index(int jl, int k) const {
    return (std::size_t(jl + reach) * layout.nz + k) * (layout.blocks + 2) + 1;
  }
  RowFields fields(int jl, int k);
  void select_column(int jl);
  int first_row() const { return partition.south >= 0 ? -reach : 0; }

  FixedEdges fixed_;
  BondTables tables_;
  std::vector<std::uint8_t> touched_;     // ghost rows and blocks included
  std::vector<std::uint8_t> near_hull_;   // own blocks
  std::vector<RowFields> column_fields_;  // of the selected column, by layer
  std::vector<RowTables> column_tables_;
  std::vector<float> reference_x_, mobile_x_, nothing_mobile_;
};

}  // namespace icebow
