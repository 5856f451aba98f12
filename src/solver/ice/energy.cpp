#include "solver/ice/energy.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "solver/model/exact_sum.h"

namespace icebow {
namespace {

// Where the fits of the bond law end and it goes on linearly in e (kernel.h): e = -0.19, s = -0.1.
constexpr double e_min = -0.19, s_min = -0.1;
const double H_min = 1.0 / (std::sqrt(1.0 + e_min) * (1.0 + std::sqrt(1.0 + e_min)));

struct BlockEnergy {
  double elastic[block] = {}, fracture[block] = {};
};

// Distortional energies of a block's bonds to higher ends, over mass/2. A bond that never was has no weight.
template <class Real, bool per_lane>
void add_bonds(const Real* const (&u)[3], const RowTables<Real>& t, const Real* slot,
               const std::uint16_t* words, double s0, BlockEnergy& sum) {
  constexpr int width = per_lane ? block : 1;
  for (int s = 0; s < t.n_slots; ++s, slot += std::ptrdiff_t(constants_per_slot) * width) {
    const std::ptrdiff_t n = t.neighbour[s];
    const unsigned word = words[s];
    for (int l = 0; l < block; ++l) {
      const auto constant = [&](int which) { return double(slot[which * width + (per_lane ? l : 0)]); };
      double q = 0.0;
      for (int c = 0; c < 3; ++c) {
        const double eta = double(u[c][l + n]) - double(u[c][l]);
        q += eta * (eta + 2.0 * constant(xi_x + c));
      }
      const double e = q * constant(inverse_L2), inside = std::max(e, e_min);
      const double stretch = inside / (1.0 + std::sqrt(1.0 + inside));
      const double beyond = e < e_min ? H_min * (e * e - e_min * e_min) : 0.0;
      const double weight = constant(distortion_weight) / constant(inverse_L2);
      const double alive = (word >> l) & 1u;
      sum.elastic[l] += alive * weight * (stretch * stretch + 0.5 * beyond);
      sum.fracture[l] += (1.0 - alive) * weight * s0 * s0;
    }
  }
}

// The one place that reads the sheet's fields for bonds.
template <class Real>
BlockEnergy block_bonds(const IceSheet& sheet, const RowTables<Real>& t, int jl, int k, int b, double s0) {
  const std::size_t p = sheet.layout.row(jl, k) + std::size_t(b) * block;
  const auto at = [p](const Field& f) { return f.data<Real>() + p; };
  const Real* const u[3] = {at(sheet.u[0]), at(sheet.u[1]), at(sheet.u[2])};
  const std::uint16_t* words = sheet.bits.row(jl, k) + std::ptrdiff_t(b) * sheet.bits.per_block();
  BlockEnergy sum;
  if (t.ends[b]) {
    add_bonds<Real, true>(u, t, t.ends[b], words, s0, sum);
  } else {
    add_bonds<Real, false>(u, t, t.interior, words, s0, sum);
  }
  return sum;
}

// m v- . v+ / 2 of one particle at height z.
double kinetic(const IceSheet& sheet, const EnergyModel& m, std::size_t p, double z) {
  double product = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double v = sheet.v[c][p];
    const double a = sheet.acceleration[c][p] + (c == 2 ? m.weight_and_lift(z) : 0.0);
    product += v * (v + m.dt * a);
  }
  return 0.5 * m.mass * product;
}

}  // namespace

EnergyModel::EnergyModel(const Scenario& s, const Lattice& lattice, const Material& material, double step)
    : mass(s.ice.rho * lattice.particle_volume()),
      dilatation(material.a * lattice.particle_volume()),
      s0(material.s0),
      gravity(s.water.buoyancy_and_gravity ? icebow::gravity : 0.0),
      lift(gravity * s.water.rho / s.ice.rho),
      dx(lattice.dx),
      inverse_dx(1.0 / dx),
      dt(step),
      V(s.V),
      quantum(std::ldexp(mass * (s.V * s.V + icebow::gravity * s.ice.h), -32)) {}

std::int64_t EnergyModel::quanta(double joules) const {
  return whole_multiples(joules, quantum);
}

double EnergyModel::weight_and_lift(double z) const {
  return lift * std::clamp(0.5 - z * inverse_dx, 0.0, 1.0) - gravity;
}

double EnergyModel::potential(double z) const {
  const double half = 0.5 * dx;
  // Integral of the submerged part from above the water down to z.
  const double submerged = z >= half ? 0.0 : z <= -half ? z : 0.5 * z - 0.5 * z * z * inverse_dx - 0.125 * dx;
  return mass * (gravity * z - lift * submerged);
}

// Rounded block by block: a rank owns whole blocks, so their sums are the same on any number of ranks.
EnergyCounts motion_energy(const IceSheet& sheet, const EnergyModel& m) {
  const Layout& layout = sheet.layout;
  EnergyCounts sum;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const double reference = sheet.lattice.z(k), afloat = m.potential(reference);
      for (int b = 0; b < layout.blocks; ++b) {
        const std::size_t first = layout.row(jl, k) + std::size_t(b) * block;
        double in_motion = 0.0, in_height = 0.0;
        for (std::size_t p = first; p < first + block; ++p) {
          const double z = reference + sheet.u[2][p];
          in_motion += kinetic(sheet, m, p, z);
          in_height += m.potential(z) - afloat;
        }
        sum.kinetic += m.quanta(in_motion);
        sum.potential += m.quanta(in_height);
      }
    }
  }
  return sum;
}

namespace {

template <class Real>
void add_bond_energy(const IceSheet& sheet, const EnergyModel& m, EnergyCounts& sum) {
  const Layout& layout = sheet.layout;
  // A bond across the symmetry plane of a half model: half of it is the image's.
  for (int jl = sheet.at_symmetry_plane() ? -reach : 0; jl < layout.columns; ++jl) {
    const double part = jl < 0 ? 0.25 : 0.5, dilatation = jl < 0 ? 0.0 : m.dilatation;
    for (int k = 0; k < layout.nz; ++k) {
      const RowTables<Real> tables = sheet.tables<Real>().row(jl, k);
      for (int b = 0; b < layout.blocks; ++b) {
        const BlockEnergy bonds = block_bonds(sheet, tables, jl, k, b, m.s0);
        const std::size_t first = layout.row(jl, k) + std::size_t(b) * block;
        double elastic = 0.0, fracture = 0.0;
        for (int l = 0; l < block; ++l) {
          const double theta = sheet.theta[first + l];
          elastic += dilatation * theta * theta + part * m.mass * bonds.elastic[l];
          fracture += part * m.mass * bonds.fracture[l];
        }
        sum.elastic += m.quanta(elastic);
        sum.fracture += m.quanta(fracture);
      }
    }
  }
}

}  // namespace

EnergyCounts sheet_energy(const IceSheet& sheet, const EnergyModel& m) {
  EnergyCounts sum = motion_energy(sheet, m);
  if (sheet.precision == Precision::fp64) {
    add_bond_energy<double>(sheet, m, sum);
  } else {
    add_bond_energy<float>(sheet, m, sum);
  }
  return sum;
}

}  // namespace icebow
