#include "solver/ice/sheet.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

// Columns held at a fixed edge: as many as a bond can reach, so that the free ice never feels the edge's
// surface.
constexpr int held_columns = reach;

// Bonds of linear blocks stay this far below the critical stretch.
constexpr double linear_stretch = 0.25;

// Largest dilatation up to which no bond breaks by its stress, where displacements' gradients are `gradient`
// at most: stretches are sqrt(3) of that.
double safe_theta(const Material& m, double gradient) {
  if (!(m.tensile_strength > 0.0)) return 1e30;
  return (0.99 * m.tensile_strength - m.normal_stress(std::sqrt(3.0) * gradient, 0.0)) /
         m.normal_stress(0.0, 1.0);
}

}  // namespace

BondBits::BondBits(const Lattice& lattice, const Layout& layout, const Stencil& stencil)
    : blocks_(layout.blocks),
      columns_(layout.columns),
      per_block_(stencil.column_slots()),
      first_slot_(stencil.first_slot),
      words_(std::size_t(layout.columns + reach) * (layout.blocks + 2) * stencil.column_slots()) {
  for (int jl = -reach; jl < layout.columns; ++jl) {
    for (int b = -1; b <= layout.blocks; ++b) {
      for (int k = 0; k < lattice.nz; ++k) {
        std::uint16_t* words = &words_[index(jl, b, k)];
        for (int s = 0; s < stencil.slots(k); ++s) {
          words[s] = whole(lattice, stencil.half[k][s], layout.i0 + b * block, layout.j0 + jl);
        }
      }
    }
  }
}

std::uint16_t BondBits::whole(const Lattice& lattice, const Offset& o, int first, int j) {
  // Below 0 are the mirror images of a half model: their bonds among themselves are the port half's.
  if ((j < 0 && !(lattice.half && j + o.dj >= 0)) || j + o.dj >= lattice.ny) return 0;
  unsigned word = 0;
  for (int l = 0; l < block; ++l) {
    const int i = first + l, i2 = i + o.di;
    if (i >= 0 && i < lattice.nx && i2 >= 0 && i2 < lattice.nx) word |= 1u << l;
  }
  return static_cast<std::uint16_t>(word);
}

std::int64_t BondBits::count(int jl0, int jl1) const {
  std::int64_t n = 0;
  for (int jl = jl0; jl < jl1; ++jl) {
    const std::uint16_t* words = row(jl, 0);
    for (int w = 0; w < blocks_ * per_block_; ++w) n += __builtin_popcount(words[w]);
  }
  return n;
}

IceSheet::IceSheet(const Scenario& s, const Lattice& l, const Partition& p, const Material& material,
                   const Kernels& kernels_used)
    : lattice(l),
      partition(p),
      layout(l, p),
      stencil(make_stencil(l.nz, l.dx, material.delta)),
      kernel(kernels_used),
      precision(s.numerics.precision),
      u{{layout.size, precision, 0}, {layout.size, precision, 1}, {layout.size, precision, 2}},
      v{{layout.size, precision, 3}, {layout.size, precision, 4}, {layout.size, precision, 5}},
      residual{{layout.size, precision, 6}, {layout.size, precision, 7}, {layout.size, precision, 8}},
      acceleration{{layout.size, precision, 9}, {layout.size, precision, 10}, {layout.size, precision, 11}},
      theta(layout.size, precision, 12),
      extra_strength(layout.size, precision, 13),
      crushed_depth(layout.size, precision, 14),
      touched_face(layout.size, precision, 15),
      bits(l, layout, stencil),
      sides_held_(s.sheet.fixed != FixedEdges::none),
      // What a window lays ahead is at rest: bonds to ice that moves would be torn as they are made.
      far_end_held_(s.sheet.fixed == FixedEdges::sides_and_far || s.sheet.window_ahead > 0.0),
      work_(make_work(s, material)),
      state_(std::size_t(layout.columns + reach) * l.nz * (layout.blocks + 2), calm) {
  if (s.sheet.window_ahead > 0.0) hold_far_end_together();
  find_cracks();
}

std::variant<IceSheet::Work<float>, IceSheet::Work<double>> IceSheet::make_work(
    const Scenario& s, const Material& material) const {
  if (precision == Precision::fp64) return make_work<double>(s, material);
  return make_work<float>(s, material);
}

template <class Real>
IceSheet::Work<Real> IceSheet::make_work(const Scenario& s, const Material& material) const {
  const BondTableOptions options{s.numerics.surface_correction, s.ice.rho};
  const double linear_below = std::min(s.numerics.linear_below, linear_stretch * material.s0);
  const BondLaw<Real> law = make_bond_law<Real>(material);
  Work<Real> work{law,
                  BondTables<Real>(lattice, layout, stencil, material, options),
                  Families<Real>(lattice, layout, stencil, material, options),
                  ColumnTables<Real>(lattice, layout, stencil, material, options, law),
                  CrushWatch<Real>(layout),
                  {},
                  {},
                  {},
                  std::vector<Real>(std::size_t(layout.columns) * layout.nz * layout.blocks),
                  std::vector<Real>(std::size_t(layout.columns) * layout.blocks * block),
                  LinearTables<Real>(lattice, layout, stencil, material, options),
                  LinearBlocks<Real>(lattice, layout, linear_below),
                  std::vector<std::uint8_t>(layout.blocks),
                  static_cast<Real>(safe_theta(material, linear_below))};
  for (int local = 0; local < layout.blocks * block; ++local) {
    const int i = layout.i0 + local;
    const bool far_end = far_end_held_ && i >= lattice.nx - held_columns;
    work.mobile_x.push_back(i < lattice.nx && !far_end ? Real(1) : Real(0));
    work.nothing_mobile.push_back(Real(0));
  }
  return work;
}

bool IceSheet::held(int i, int j) const {
  if (far_end_held_ && i >= lattice.nx - held_columns) return true;
  return sides_held_ && ((!lattice.half && j < held_columns) || j >= lattice.ny - held_columns);
}

std::size_t IceSheet::bytes() const {
  return 14 * theta.element_size() * layout.size + bits.bytes() + state_.size() +
         (state_.size() / (layout.blocks + 2)) * layout.blocks * theta.element_size() +
         std::size_t(layout.columns) * layout.blocks * block * theta.element_size() +
         there_.size() * sizeof there_[0];
}

template <class Real>
RowFields<Real> IceSheet::fields(const Work<Real>& work, int jl, int k, const std::uint8_t* crush) {
  const std::size_t r = layout.row(jl, k);
  const auto at = [r](Field& f) { return f.data<Real>() + r; };
  return {{at(u[0]), at(u[1]), at(u[2])},
          at(extra_strength),
          {at(acceleration[0]), at(acceleration[1]), at(acceleration[2])},
          at(theta),
          bits.row(jl, k),
          bits.per_block(),
          bonds_there(jl),
          bonds_there_,
          layout.blocks,
          state(jl, k),
          work.linear.enabled() ? work.linear.linear(jl) : work.none.data(),
          crush};
}

template <class Real>
void IceSheet::drift_column(Work<Real>& work, const DriftSettings& settings, int jl) {
  const bool moves = !held(0, layout.j0 + jl);
  for (int k = 0; k < layout.nz; ++k) {
    const std::size_t r = layout.row(jl, k);
    const auto at = [r](Field& f) { return f.data<Real>() + r; };
    kernel.passes<Real>().drift({{at(u[0]), at(u[1]), at(u[2])},
                                 {at(v[0]), at(v[1]), at(v[2])},
                                 {at(residual[0]), at(residual[1]), at(residual[2])},
                                 {at(acceleration[0]), at(acceleration[1]), at(acceleration[2])},
                                 moves ? work.mobile_x.data() : work.nothing_mobile.data(),
                                 static_cast<Real>(lattice.z(k)),
                                 &work.travelled2[(std::size_t(jl) * layout.nz + k) * layout.blocks],
                                 layout.blocks},
                                settings);
  }
}

void IceSheet::drift(const DriftSettings& settings, int jl0, int jl1) {
  std::visit(
      [&](auto& work) {
        for (int jl = jl0; jl < jl1; ++jl) drift_column(work, settings, jl);
      },
      work_);
}

template <class Real>
void IceSheet::select_column(Work<Real>& work, int jl, const std::uint8_t* crush) {
  work.fields.clear();
  for (int k = 0; k < layout.nz; ++k) work.fields.push_back(fields(work, jl, k, crush));
}

void IceSheet::find_cracks() {
  const auto find = [this](auto& work) {
    bonds_there_ = 0;
    for (const auto& family : stencil.family) bonds_there_ += static_cast<int>(family.size());
    there_.assign(std::size_t(layout.columns) * layout.blocks * bonds_there_, 0);
    for (int row = 0; row < layout.columns * layout.nz; ++row) {
      const int jl = row / layout.nz, k = row % layout.nz;
      const auto& family = work.families.column(jl)[k];
      for (int b = 0; b < layout.blocks; ++b) {
        const std::uint16_t* const words = bits.row(jl, k) + std::ptrdiff_t(b) * bits.per_block();
        std::uint16_t* const there = bonds_there(jl) + std::ptrdiff_t(b) * bonds_there_;
        bool missing = false;
        for (int n = 0; n < family.bonds; ++n) {
          const unsigned now = alive(words + family.word[n].word, bits.per_block(), family.word[n].shift);
          there[family.word[n].place] = static_cast<std::uint16_t>(now);
          missing |= now != (family.whole[b] ? family.whole[b][n] : 0xffffu);
        }
        std::uint8_t& s = state(jl, k)[b];
        s = static_cast<std::uint8_t>(missing ? s | cracked : s & ~cracked);
      }
    }
    work.crushed.forget();
  };
  std::visit(find, work_);
}

// The sum of the words: a bond that breaks takes a bit out of one.
std::int64_t IceSheet::bond_mark(int jl, int b) const {
  const std::uint16_t* const there = &there_[(std::size_t(jl) * layout.blocks + b) * bonds_there_];
  std::uint32_t sum = 0;
  for (int n = 0; n < bonds_there_; ++n) sum += there[n];
  return sum;
}

template <class Real>
LinearFields<Real> IceSheet::linear_fields(int jl) {
  const std::size_t r = layout.row(jl, 0);
  const auto at = [r](Field& f) { return f.data<Real>() + r; };
  return {{at(u[0]), at(u[1]), at(u[2])},
          at(theta),
          {at(acceleration[0]), at(acceleration[1]), at(acceleration[2])},
          layout.stride,
          layout.nz * layout.stride};
}

template <class Real>
ColumnFields<Real> IceSheet::column_fields(Work<Real>& work, int jl) {
  const bool few = layout.nz <= most_linear_layers;
  return {linear_fields<Real>(jl),
          {few ? work.at_once.of(calm, jl) : nullptr, few ? work.at_once.of(bent, jl) : nullptr},
          &work.strain[std::size_t(jl) * layout.blocks * block]};
}

template <class Real>
typename LinearBlocks<Real>::Ice IceSheet::ice(int jl, const std::uint8_t* crush) {
  return {kernel.passes<Real>(), linear_fields<Real>(0), state(jl, 0), layout.blocks + 2, crush};
}

template <class Real>
Broken IceSheet::dilate_column(Work<Real>& work, int jl) {
  const Passes<Real>& passes = passes_of(work);
  if (jl == 0) {
    work.crushed.start_step();
    work.linear.start_step();
  }
  const std::uint8_t* const crush =
      work.crushed.near(passes, extra_strength.data<Real>() + layout.row(0, 0), jl);
  if (work.linear.enabled()) work.linear.settle(ice<Real>(jl, crush), jl);
  select_column(work, jl, crush);
  const Broken broken = passes.dilatation(column_fields(work, jl), work.fields.data(),
                                          work.families.column(jl), layout.nz, work.law);
  if (!work.linear.enabled()) return broken;
  const LinearPasses<Real>& linear = passes.linear[layout.nz - 1];
  for (int b = 0; b < layout.blocks; ++b) {
    if (!work.linear.linear(jl)[b]) continue;
    const auto run = work.linear_tables.is_end(b) ? linear.theta_at_end : linear.theta;
    run(linear_fields<Real>(jl), work.linear_tables.of(jl, b), b);
  }
  return broken;
}

template <class Real>
Broken IceSheet::force_column(Work<Real>& work, int jl) {
  const Passes<Real>& passes = passes_of(work);
  select_column(work, jl, work.none.data());
  const ColumnFields<Real> column = column_fields(work, jl);
  const FamilyTables<Real>* const families = work.families.column(jl);
  Broken broken = passes.force(column, work.fields.data(), families, layout.nz, work.law);
  if (!work.linear.enabled()) return broken;
  const LinearPasses<Real>& linear = passes.linear[layout.nz - 1];
  for (int b = 0; b < layout.blocks; ++b) {
    if (!work.linear.linear(jl)[b]) continue;
    const auto run = work.linear_tables.is_end(b) ? linear.force_at_end : linear.force;
    if (run(linear_fields<Real>(jl), work.linear_tables.of(jl, b), b) <= work.safe_theta) continue;
    const Broken more = passes.look_closer(column, work.fields.data(), families, layout.nz, work.law, b);
    broken.own += more.own;
    broken.image += more.image;
  }
  return broken;
}

std::int64_t IceSheet::dilatation(int jl0, int jl1) {
  std::int64_t broken = 0;
  const auto pass = [&](auto& work) {
    for (int jl = jl0; jl < jl1; ++jl) broken += in_whole_sheet(dilate_column(work, jl));
  };
  std::visit(pass, work_);
  return broken;
}

std::int64_t IceSheet::force(int jl0, int jl1) {
  std::int64_t broken = 0;
  const auto pass = [&](auto& work) {
    for (int jl = jl0; jl < jl1; ++jl) broken += in_whole_sheet(force_column(work, jl));
  };
  std::visit(pass, work_);
  return broken;
}

bool IceSheet::is_linear(int jl, int b) const {
  return std::visit([&](const auto& work) { return work.linear.linear(jl)[b] != 0; }, work_);
}

LinearCount IceSheet::linear_blocks() const {
  const auto count = [](const auto& work) { return static_cast<std::int64_t>(work.linear.count()); };
  return {std::visit(count, work_), std::int64_t{layout.columns} * layout.blocks};
}

}  // namespace icebow
