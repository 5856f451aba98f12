#include "solver/water_reaction.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace icebow {
namespace {

// Beyond this part of its thickness a column is longer or shorter than any ice that still is a plate.
constexpr double crushed = 0.3;

// A face is wet once it is a spacing below the water; in between by its share, so that nothing jumps.
template <class Real>
Real wet(Real depth_over_dx) {
  return std::min(std::max(depth_over_dx, Real(0)), Real(1));
}

// A rank's particles of one column, by their address in the fields: the layers are `layer` apart.
template <class Real>
struct Columns {
  Real* acceleration[3];
  const Real* u[3];
  Real* v[3];
  std::ptrdiff_t layer;
  int nz;
  Real z0, dx;
};

template <class Real>
struct Reaction {
  Real added_mass, drag, mass, gravity, lift, dt;
};

// A column as a piece of plate.
template <class Real>
struct Plate {
  Real n[3];        // normal; not of unit length where the column is crushed
  Real added_mass;  //!< [kg]; 0 where it is crushed, as the drag
  Real drag;        //!< [kg/m]
};

template <class Real>
Plate<Real> plate_of(const Columns<Real>& c, const Reaction<Real>& w, std::ptrdiff_t p) {
  const std::ptrdiff_t top = p + (c.nz - 1) * c.layer;
  const Real height = Real(c.nz - 1) * c.dx, inverse_dx = Real(1) / c.dx;
  Plate<Real> plate{
      {c.u[0][top] - c.u[0][p], c.u[1][top] - c.u[1][p], c.u[2][top] - c.u[2][p] + height}, 0, 0};
  Real* const n = plate.n;
  if (c.nz == 1) n[2] = Real(1);
  const Real length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (c.nz > 1 && std::abs(length - height) > Real(crushed) * height) return plate;
  for (int i = 0; i < 3; ++i) n[i] /= length;
  const Real face = Real(0.5) * c.dx * std::abs(n[2]), z_first = c.z0 + c.u[2][p],
             z_last = c.z0 + height + c.u[2][top];
  const Real low = wet((face - std::min(z_first, z_last)) * inverse_dx),
             high = wet((-face - std::max(z_first, z_last)) * inverse_dx);
  plate.added_mass = w.added_mass * low;
  plate.drag = Real(0.5) * (low + high) * w.drag;
  return plate;
}

template <class Real>
Real mean_along(const Columns<Real>& c, const Plate<Real>& plate, Real* const (&field)[3], std::ptrdiff_t p) {
  Real sum = 0;
  for (int k = 0; k < c.nz; ++k) {
    for (int i = 0; i < 3; ++i) sum += plate.n[i] * field[i][p + k * c.layer];
  }
  return sum / Real(c.nz);
}

// Energy given to the water by column p in a step [J]. `struck`: what the hull changed the velocities of its
// particles by, all together.
template <class Real>
Real react(const Columns<Real>& c, const Reaction<Real>& w, std::ptrdiff_t p, const Vec3& struck) {
  const Plate<Real> plate = plate_of(c, w, p);
  if (plate.added_mass == 0 && plate.drag == 0) return 0;
  Real vertical = 0, strike = 0;
  for (int k = 0; k < c.nz; ++k) {
    const Real z = c.z0 + Real(k) * c.dx + c.u[2][p + k * c.layer];
    vertical += w.lift * wet(Real(0.5) - z / c.dx) - w.gravity;
  }
  for (int i = 0; i < 3; ++i) strike += plate.n[i] * static_cast<Real>(struck[i]);
  const Real share = Real(1) / Real(c.nz), M = w.mass * Real(c.nz), m = plate.added_mass;
  const Real v = mean_along(c, plate, c.v, p);
  const Real a = mean_along(c, plate, c.acceleration, p) + share * plate.n[2] * vertical;
  // (M + m) a' = M (a + strike / dt) - drag, eq. (41); the strike itself has been.
  const Real drag = plate.drag * std::abs(v) * v;
  const Real change = -(m * (a + share * strike / w.dt) + drag) / (M + m);
  for (int k = 0; k < c.nz; ++k) {
    for (int i = 0; i < 3; ++i) c.acceleration[i][p + k * c.layer] += change * plate.n[i];
  }
  return -M * change * (v + Real(0.5) * w.dt * (a + change)) * w.dt;
}

}  // namespace

WaterReaction::WaterReaction(const Scenario& s, double dx, const EnergyModel& model)
    : model_(model),
      added_mass_(s.water.rho * s.water.added_mass * dx * dx),
      drag_(0.5 * s.water.rho * s.water.drag * dx * dx),
      dx_(dx) {}

namespace {

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

template <class Real>
std::int64_t WaterReaction::apply_to(IceSheet& sheet, const std::vector<HullStrike>& strikes) const {
  const Layout& layout = sheet.layout;
  const auto real = [](double value) { return static_cast<Real>(value); };
  Columns<Real> columns{{}, {}, {}, layout.stride, layout.nz, real(sheet.lattice.z0), real(dx_)};
  for (int c = 0; c < 3; ++c) {
    columns.acceleration[c] = sheet.acceleration[c].data<Real>();
    columns.u[c] = sheet.u[c].data<Real>();
    columns.v[c] = sheet.v[c].data<Real>();
  }
  const Reaction<Real> water{real(added_mass_),    real(drag_),       real(model_.mass),
                             real(model_.gravity), real(model_.lift), real(model_.dt)};
  const std::map<std::ptrdiff_t, Vec3> struck = by_column(strikes, layout);
  auto next = struck.begin();
  const Vec3 not_struck = Vec3::Zero();
  std::int64_t taken = 0;
  for (int jl = 0; jl < layout.columns; ++jl) {
    const auto row = static_cast<std::ptrdiff_t>(layout.row(jl, 0));
    for (int b = 0; b < layout.blocks; ++b) {
      double joules = 0.0;
      for (int l = b * block; l < (b + 1) * block; ++l) {
        if (!sheet.mobile(jl, l)) continue;
        const bool hit = next != struck.end() && next->first == row + l;
        joules += react(columns, water, row + l, hit ? next->second : not_struck);
        if (hit) ++next;
      }
      taken += model_.quanta(joules);
    }
  }
  return taken;
}

std::int64_t WaterReaction::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) const {
  return sheet.precision == Precision::fp64 ? apply_to<double>(sheet, strikes)
                                            : apply_to<float>(sheet, strikes);
}

}  // namespace icebow
