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

// Zeroed floats on a cache-line boundary.
class Field {
 public:
  explicit Field(std::size_t n);
  float* data() const { return data_.get(); }
  float& operator[](std::size_t i) const { return data_[i]; }

 private:
  struct Free {
    void operator()(float* p) const;
  };
  std::unique_ptr<float[], Free> data_;
};

// Alive bonds: one word of 16 particles for each block and column slot.
class BondBits {
 public:
  BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil);
  std::uint16_t* row(int jl, int k) { return &words_[index(jl, 0, k)]; }
  const std::uint16_t* row(int jl, int k) const { return &words_[index(jl, 0, k)]; }
  int per_block() const { return per_block_; }
  std::int64_t count() const;  // alive directed bonds of this rank

 private:
  // Blocks of a row follow each other, each with the slots of all layers of the column.
  std::size_t index(int jl, int b, int k) const {
    return (std::size_t(jl) * blocks_ + b) * per_block_ + first_slot_[k];
  }
  int blocks_, per_block_;
  std::vector<int> first_slot_;
  std::vector<std::uint16_t> words_;
};

class IceSheet {
 public:
  IceSheet(const Scenario& scenario, const Lattice& lattice, const Partition& partition,
        const Material& material);

  const Lattice lattice;
  const Partition partition;
  const Layout layout;
  const Stencil stencil;

  Field u[3], v[3], residual[3], theta;
  BondBits bits;

  const Kernels& kernel() const { return *kernel_; }
  void use(const Kernels& kernels) { kernel_ = &kernels; }  // another vector width than the widest, for tests

  // Passes in the order of a step. `settings.box_*` is where the hull may be.
  void drift(const DriftSettings& settings);    // v += dt g; u += dt v; finds blocks near the hull
  std::int64_t dilatation(const BondLaw& law);  // breaks bonds; returns how many bond ends broke
  void force(const BondLaw& law, double dt);    // v += dt a

  bool near_hull(int jl, int k, int b) const {
    return near_hull_[(std::size_t(jl) * layout.nz + k) * layout.blocks + b];
  }
  bool held(int i, int j) const;  // fixed edge
  bool mobile(int jl, int local_i) const {
    return !held(layout.i0 + local_i, layout.j0 + jl) && layout.i0 + local_i < lattice.nx;
  }

 private:
  RowFields fields(int jl, int k);

  const Kernels* kernel_;
  FixedEdges fixed_;
  BondTables tables_;
  std::vector<std::uint8_t> touched_, near_hull_;
  std::vector<float> reference_x_, mobile_x_;
};

}  // namespace icebow
