#include "solver/water/water_reaction.h"

#include <algorithm>
#include <cmath>

#include "solver/model/exact_sum.h"

namespace icebow {
namespace {

// Cells about as wide as the sheet is thick: blocks of particles are whole cells.
int columns_per_cell(int layers) {
  return layers < 3 ? 2 : 4;
}

// The columns the hull has struck, by address of their lowest particle.
std::vector<std::pair<std::ptrdiff_t, Vec3>> by_column(const std::vector<HullStrike>& strikes,
                                                       const Layout& layout) {
  std::vector<std::pair<std::ptrdiff_t, Vec3>> columns;
  for (const HullStrike& strike : strikes) {
    const Layout::Place at = layout.place(strike.p);
    columns.emplace_back(static_cast<std::ptrdiff_t>(layout.row(at.jl, 0)) + at.il, strike.delta_v);
  }
  // Of one column in the order of its layers, as they come.
  std::stable_sort(columns.begin(), columns.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return columns;
}

}  // namespace

WaterReaction::WaterReaction(const Communicator& comm, const Scenario& s, const Lattice& lattice,
                             const EnergyModel& model)
    : comm_(comm), model_(model) {
  law_.added_mass = s.water.rho * s.water.added_mass * model.dx * model.dx;
  law_.drag = 0.5 * s.water.rho * s.water.drag * model.dx * model.dx;
  law_.thickness = s.ice.h;
  law_.plane = s.water.inertia == WaterInertia::plane;
  law_.mass = model.mass;
  law_.dx = model.dx;
  law_.dt = model.dt;
  law_.gravity = model.gravity;
  law_.lift = model.lift;
  law_.z0 = lattice.z0;
  if (s.water.inertia != WaterInertia::plane) return;
  cell_ = columns_per_cell(lattice.nz);
  WaterGrid grid;
  grid.nx = lattice.blocks() * (block / cell_);
  grid.ny = cells_across_ = (lattice.ny + cell_ - 1) / cell_;
  grid.cell = cell_ * lattice.dx;
  grid.mirrored = lattice.half;
  grid.density = s.water.rho;
  most_mobile_ = 1.0 / (cell_ * cell_ * model.mass * lattice.nz);
  plane_ = std::make_unique<WaterPlane>(grid, most_mobile_);
}

template <class Real>
WaterFields<Real> WaterReaction::fields(IceSheet& sheet, int jl, int b) const {
  const std::size_t p = sheet.layout.row(jl, 0) + std::size_t(b) * block;
  const auto at = [p](Field& f) { return f.data<Real>() + p; };
  return {{at(sheet.u[0]), at(sheet.u[1]), at(sheet.u[2])},
          {at(sheet.v[0]), at(sheet.v[1]), at(sheet.v[2])},
          {at(sheet.acceleration[0]), at(sheet.acceleration[1]), at(sheet.acceleration[2])},
          sheet.layout.stride,
          sheet.layout.nz};
}

const WaterStrikes* WaterReaction::strikes_at(const Layout& layout, int jl, int b, const Struck& struck) {
  const auto first = static_cast<std::ptrdiff_t>(layout.row(jl, 0)) + b * block;
  auto at = std::lower_bound(struck.begin(), struck.end(), first,
                             [](const auto& s, std::ptrdiff_t place) { return s.first < place; });
  if (at == struck.end() || at->first >= first + block) return nullptr;
  strikes_ = {};
  for (; at != struck.end() && at->first < first + block; ++at)
    for (int c = 0; c < 3; ++c) strikes_.delta_v[c][at->first - first] += at->second[c];
  return &strikes_;
}

unsigned WaterReaction::mobile(const IceSheet& sheet, int jl, int b) {
  const Layout& layout = sheet.layout;
  if (mobile_.empty()) {
    for (int j = 0; j < layout.columns; ++j) {
      for (int l = 0; l < layout.blocks * block; ++l) {
        if (l % block == 0) mobile_.push_back(0);
        if (sheet.mobile(j, l)) mobile_.back() |= static_cast<std::uint16_t>(1u << l % block);
      }
    }
  }
  return mobile_[std::size_t(jl) * layout.blocks + b];
}

// A cell's acceleration is the mean over its columns, by their shares; its force is theirs by the same.
void WaterReaction::resist_plane(const Layout& layout) {
  constexpr double acceleration_quantum = 1.0 / (1 << 30), mobility_quantum = 1.0 / (1 << 30);
  const double columns = cell_ * cell_;
  const std::size_t cells = plane_->cells();
  std::vector<std::int64_t> sums(2 * cells, 0);
  const auto for_each = [&](auto visit) {
    for (std::size_t n = 0; n < blocks_.size(); ++n) {
      const int jl = static_cast<int>(n) / layout.blocks, b = static_cast<int>(n) % layout.blocks;
      for (int l = 0; l < block; ++l) {
        if (blocks_[n].mass[l] > 0.0)
          visit((layout.i0 + b * block + l) / cell_ * cells_across_ + (layout.j0 + jl) / cell_, blocks_[n],
                l);
      }
    }
  };
  for_each([&](int cell, const WaterColumns& c, int l) {
    sums[cell] += whole_multiples(c.share[l] * c.reached[l] / columns, acceleration_quantum);
    sums[cells + cell] += whole_multiples(
        c.share[l] * c.share[l] / (columns * columns * c.mass[l] * most_mobile_), mobility_quantum);
  });
  comm_.sum(sums.data(), static_cast<int>(sums.size()));
  std::vector<double> acceleration(cells), mobilities(cells);
  for (std::size_t n = 0; n < cells; ++n) {
    acceleration[n] = sums[n] * acceleration_quantum;
    mobilities[n] = sums[cells + n] * mobility_quantum * most_mobile_;
  }
  const std::vector<double> force = plane_->resistance(acceleration, mobilities);
  for_each([&](int cell, WaterColumns& c, int l) {
    c.change[l] -= c.share[l] * force[cell] / (columns * c.mass[l]);
  });
}

template <class Real>
std::int64_t WaterReaction::apply_to(IceSheet& sheet, const Struck& struck) {
  const Layout& layout = sheet.layout;
  const Passes<Real>& passes = sheet.kernel.passes<Real>();
  // All blocks at once where the plane is to be solved in between.
  blocks_.resize(plane_ ? std::size_t(layout.columns) * layout.blocks : 1);
  std::int64_t taken = 0;
  const auto for_each = [&](auto visit) {
    for (int jl = 0; jl < layout.columns; ++jl) {
      for (int b = 0; b < layout.blocks; ++b) {
        const unsigned moves = mobile(sheet, jl, b);
        WaterColumns& columns = blocks_[plane_ ? std::size_t(jl) * layout.blocks + b : 0];
        visit(fields<Real>(sheet, jl, b), moves, jl, b, columns);
      }
    }
  };
  const auto push = [&](const WaterFields<Real>& f, const WaterColumns& columns) {
    taken += model_.quanta(passes.water_push(f, law_, columns));
  };
  for_each([&](const WaterFields<Real>& f, unsigned moves, int jl, int b, WaterColumns& columns) {
    passes.water_columns(f, law_, moves, strikes_at(layout, jl, b, struck), columns);
    if (!plane_) push(f, columns);
  });
  if (!plane_) return taken;
  resist_plane(layout);
  for_each(
      [&](const WaterFields<Real>& f, unsigned, int, int, const WaterColumns& columns) { push(f, columns); });
  return taken;
}

std::int64_t WaterReaction::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  const Struck struck = by_column(strikes, sheet.layout);
  return sheet.precision == Precision::fp64 ? apply_to<double>(sheet, struck)
                                            : apply_to<float>(sheet, struck);
}

}  // namespace icebow
