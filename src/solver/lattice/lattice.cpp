#include "solver/lattice/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/errors.h"

namespace icebow {
namespace {

// Start of part p when n items are dealt to `parts` as evenly as can be.
int share(int n, int parts, int p) {
  return static_cast<int>(std::int64_t(n) * p / parts);
}

// Likewise by their costs, each part of `least` items at least.
int share(const std::vector<double>& costs, int least, int parts, int p) {
  const int n = static_cast<int>(costs.size());
  const double target = std::accumulate(costs.begin(), costs.end(), 0.0) * p / parts;
  int begin = 0;
  for (double before = 0.0; begin < n && before + 0.5 * costs[begin] < target; ++begin)
    before += costs[begin];
  return std::clamp(begin, least * p, n - least * (parts - p));
}

// Columns (y) or rows of particles (x) that one rank copies from its neighbours and computes again, on a px x
// py grid: what the choice of grid minimises.
double halo_size(const Lattice& lattice, int px, int py) {
  const double across = px > 1 ? 2.0 * ghost_blocks * block * lattice.ny / py : 0.0;
  const double along = py > 1 ? 2.0 * reach * lattice.nx / px : 0.0;
  return across + along;
}

}  // namespace

Lattice make_lattice(const Scenario& s) {
  Lattice lattice;
  lattice.dx = s.numerics.dx;
  lattice.nx = static_cast<int>(std::lround(s.sheet.length / lattice.dx));
  lattice.ny = static_cast<int>(std::lround(s.sheet.width / lattice.dx));
  lattice.half = s.sheet.half_model;
  if (lattice.half) lattice.ny = (lattice.ny + 1) / 2;
  // A window moves by blocks.
  if (s.sheet.window_ahead > 0.0) lattice.nx = (lattice.nx + block - 1) / block * block;
  lattice.nz = static_cast<int>(std::lround(s.ice.h / lattice.dx));
  if (lattice.nz < 1) {
    throw InputError("spacing " + std::to_string(lattice.dx) + " m is more than twice the ice thickness " +
                     std::to_string(s.ice.h) + " m: ask for at least one layer (three or more are advised)");
  }
  const double thickness = lattice.nz * lattice.dx;
  lattice.z0 = -thickness * s.ice.rho / s.water.rho + 0.5 * lattice.dx;
  return lattice;
}

Lattice whole_sheet(const Lattice& lattice) {
  Lattice whole = lattice;
  whole.ny += lattice.mirrored_columns();
  whole.half = false;
  return whole;
}

std::vector<double> column_costs(const Lattice& lattice, double half_breadth) {
  // Measured: docs/performance.md.
  constexpr double broken = 1.4;
  std::vector<double> costs;
  for (int j = 0; j < lattice.ny; ++j) costs.push_back(std::abs(lattice.y(j)) < half_breadth ? broken : 1.0);
  return costs;
}

Partition make_partition(const Lattice& lattice, int rank, int ranks, int along_x,
                         const std::vector<double>& column_costs) {
  Partition best;
  double best_halo = std::numeric_limits<double>::infinity();
  for (int px = 1; px <= ranks; ++px) {
    if (ranks % px || (along_x && px != along_x)) continue;
    const int py = ranks / px;
    if (px > 1 && lattice.blocks() < ghost_blocks * px) continue;
    if (lattice.ny < reach * py) continue;
    const double halo = halo_size(lattice, px, py);
    if (halo < best_halo) {
      best_halo = halo;
      best.px = px;
      best.py = py;
    }
  }
  if (!std::isfinite(best_halo)) {
    throw InputError("a sheet of " + std::to_string(lattice.nx) + " x " + std::to_string(lattice.ny) +
                     " particles cannot be shared by " + std::to_string(ranks) +
                     " ranks: use fewer (each needs 32 particles along x and 3 across)");
  }
  const int cx = rank % best.px, cy = rank / best.px;
  best.block0 = share(lattice.blocks(), best.px, cx);
  best.block1 = share(lattice.blocks(), best.px, cx + 1);
  if (column_costs.empty()) {
    best.j0 = share(lattice.ny, best.py, cy);
    best.j1 = share(lattice.ny, best.py, cy + 1);
  } else {
    best.j0 = share(column_costs, reach, best.py, cy);
    best.j1 = share(column_costs, reach, best.py, cy + 1);
  }
  if (cx > 0) best.west = rank - 1;
  if (cx + 1 < best.px) best.east = rank + 1;
  if (cy > 0) best.south = rank - best.px;
  if (cy + 1 < best.py) best.north = rank + best.px;
  return best;
}

Layout::Layout(const Lattice& lattice, const Partition& part)
    : nz(lattice.nz),
      blocks(part.block1 - part.block0),
      columns(part.j1 - part.j0),
      i0(part.block0 * block),
      j0(part.j0),
      stride(std::ptrdiff_t(blocks + 2 * ghost_blocks) * block),
      size(std::size_t(columns + 2 * reach) * nz * stride) {}

}  // namespace icebow
