#include "solver/water/water_reaction.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/model/exact_sum.h"

namespace icebow {
namespace {

// Beyond this part of its thickness a column is longer or shorter than any ice that still is a plate.
constexpr double crushed = 0.3;
// Ice that has moved by so many thicknesses is part of the plane; by one more, no longer.
constexpr double in_plane = 0.5;

// A face is wet once it is a spacing below the water; in between by its share, so that nothing jumps.
double wet_share(double depth_over_dx) {
  return std::clamp(depth_over_dx, 0.0, 1.0);
}

// Cells about as wide as the sheet is thick: blocks of particles are whole cells.
int columns_per_cell(int layers) {
  return layers < 3 ? 2 : 4;
}

// Of the columns the hull has struck, by address of their lowest particle.
std::map<std::ptrdiff_t, Vec3> by_column(const std::vector<HullStrike>& strikes, const Layout& layout) {
  std::map<std::ptrdiff_t, Vec3> columns;
  for (const HullStrike& strike : strikes) {
    const Layout::Place at = layout.place(strike.p);
    const auto column = static_cast<std::ptrdiff_t>(layout.row(at.jl, 0)) + at.il;
    columns.try_emplace(column, Vec3::Zero()).first->second += strike.delta_v;
  }
  return columns;
}

}  // namespace

WaterReaction::WaterReaction(const Communicator& comm, const Scenario& s, const Lattice& lattice,
                             const EnergyModel& model)
    : comm_(comm),
      model_(model),
      added_mass_(s.water.rho * s.water.added_mass * model.dx * model.dx),
      drag_(0.5 * s.water.rho * s.water.drag * model.dx * model.dx),
      thickness_(s.ice.h) {
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

// What the column is as a piece of plate: its normal, its share in the water's plane, its wet faces. False
// where it is crushed.
template <class Real>
bool WaterReaction::plate(const IceSheet& sheet, Column& column, Wet& wet) const {
  const int nz = sheet.layout.nz;
  const std::ptrdiff_t first = column.p, last = first + (nz - 1) * sheet.layout.stride;
  const double height = (nz - 1) * model_.dx;
  Vec3 low, high;
  for (int c = 0; c < 3; ++c) {
    low[c] = sheet.u[c].data<Real>()[first];
    high[c] = sheet.u[c].data<Real>()[last];
  }
  Vec3 normal = high - low;
  normal.z() += nz == 1 ? 1.0 : height;
  const double length = normal.norm();
  if (nz > 1 && std::abs(length - height) > crushed * height) return false;
  column.n = normal / length;
  const double face = 0.5 * model_.dx * std::abs(column.n.z()), z0 = sheet.lattice.z0, z_first = z0 + low.z(),
               z_last = z0 + height + high.z();
  wet.low = wet_share((face - std::min(z_first, z_last)) * model_.inverse_dx);
  wet.high = wet_share((-face - std::max(z_first, z_last)) * model_.inverse_dx);
  if (plane_) {
    const double moved = 0.5 * (low + high).norm() / thickness_;
    column.share = wet.low * column.n.z() * column.n.z() * std::clamp(1.0 + in_plane - moved, 0.0, 1.0);
  }
  return true;
}

// What it does without the plane: (M + m) a' = M (a + strike / dt) - drag, eq. (41); the strike itself has
// been.
template <class Real>
void WaterReaction::react(const IceSheet& sheet, Column& column, const Vec3& struck) const {
  Wet wet;
  if (!plate<Real>(sheet, column, wet)) return;
  const double m = added_mass_ * wet.low * (1.0 - column.share), drag = 0.5 * (wet.low + wet.high) * drag_;
  if (m == 0.0 && drag == 0.0 && column.share == 0.0) return;
  const int nz = sheet.layout.nz;
  Vec3 speed = Vec3::Zero(), acceleration = Vec3::Zero();
  for (int k = 0; k < nz; ++k) {
    const std::ptrdiff_t q = column.p + k * sheet.layout.stride;
    for (int c = 0; c < 3; ++c) {
      speed[c] += sheet.v[c].data<Real>()[q];
      acceleration[c] += sheet.acceleration[c].data<Real>()[q];
    }
    acceleration.z() += model_.weight_and_lift(sheet.lattice.z(k) + sheet.u[2].data<Real>()[q]);
  }
  const double strike = column.n.dot(struck) / (nz * model_.dt);
  column.v = column.n.dot(speed) / nz;
  column.a = column.n.dot(acceleration) / nz;
  column.mass = model_.mass * nz + m;
  column.change = -(m * (column.a + strike) + drag * std::abs(column.v) * column.v) / column.mass;
  column.reached = column.a + strike + column.change;
}

template <class Real>
void WaterReaction::find_columns(const IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  const Layout& layout = sheet.layout;
  const std::map<std::ptrdiff_t, Vec3> struck = by_column(strikes, layout);
  const Vec3 not_struck = Vec3::Zero();
  auto next = struck.begin();
  columns_.clear();
  for (int jl = 0; jl < layout.columns; ++jl) {
    const auto row = static_cast<std::ptrdiff_t>(layout.row(jl, 0));
    for (int l = 0; l < layout.blocks * block; ++l) {
      if (!sheet.mobile(jl, l)) continue;
      while (next != struck.end() && next->first < row + l) ++next;
      const bool hit = next != struck.end() && next->first == row + l;
      Column column;
      column.p = row + l;
      column.block = jl * layout.blocks + l / block;
      column.cell = (layout.i0 + l) / cell_ * cells_across_ + (layout.j0 + jl) / cell_;
      react<Real>(sheet, column, hit ? next->second : not_struck);
      if (column.mass > 0.0) columns_.push_back(column);
    }
  }
}

// A cell's acceleration is the mean over its columns, by their shares; its force is theirs by the same.
void WaterReaction::resist_plane() {
  constexpr double acceleration_quantum = 1.0 / (1 << 30), mobility_quantum = 1.0 / (1 << 30);
  const double columns = cell_ * cell_;
  const std::size_t cells = plane_->cells();
  std::vector<std::int64_t> sums(2 * cells, 0);
  for (const Column& c : columns_) {
    sums[c.cell] += whole_multiples(c.share * c.reached / columns, acceleration_quantum);
    sums[cells + c.cell] +=
        whole_multiples(c.share * c.share / (columns * columns * c.mass * most_mobile_), mobility_quantum);
  }
  comm_.sum(sums.data(), static_cast<int>(sums.size()));
  std::vector<double> acceleration(cells), mobilities(cells);
  for (std::size_t n = 0; n < cells; ++n) {
    acceleration[n] = sums[n] * acceleration_quantum;
    mobilities[n] = sums[cells + n] * mobility_quantum * most_mobile_;
  }
  const std::vector<double> force = plane_->resistance(acceleration, mobilities);
  for (Column& c : columns_) c.change -= c.share * force[c.cell] / (columns * c.mass);
}

template <class Real>
std::int64_t WaterReaction::push(IceSheet& sheet) const {
  const std::ptrdiff_t layer = sheet.layout.stride;
  const int nz = sheet.layout.nz;
  const double M = model_.mass * nz, dt = model_.dt;
  Real* acceleration[3];
  for (int c = 0; c < 3; ++c) acceleration[c] = sheet.acceleration[c].data<Real>();
  std::int64_t taken = 0;
  double joules = 0.0;
  for (std::size_t n = 0; n < columns_.size(); ++n) {
    const Column& c = columns_[n];
    for (int k = 0; k < nz; ++k) {
      for (int i = 0; i < 3; ++i) acceleration[i][c.p + k * layer] += static_cast<Real>(c.change * c.n[i]);
    }
    joules -= M * c.change * (c.v + 0.5 * dt * (c.a + c.change)) * dt;
    if (n + 1 < columns_.size() && columns_[n + 1].block == c.block) continue;
    taken += model_.quanta(joules);
    joules = 0.0;
  }
  return taken;
}

template <class Real>
std::int64_t WaterReaction::apply_to(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  find_columns<Real>(sheet, strikes);
  if (plane_) resist_plane();
  return push<Real>(sheet);
}

std::int64_t WaterReaction::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  return sheet.precision == Precision::fp64 ? apply_to<double>(sheet, strikes)
                                            : apply_to<float>(sheet, strikes);
}

}  // namespace icebow
