// The ice sheet as a uniform lattice, and one rank's part of it.
//
// The words of the solver:
//   i, j, k   a particle's place in the sheet: along the ship's course (x), across it (y), upwards (z)
//   il, jl    i and j counted from the rank's first own particle and column; ghosts lie below 0 or behind the
//   last row       the particles of one (j, k), contiguous in x, padded with ghost blocks at each end column
//   the rows of one j: all layers above each other block     16 particles of a row. Along x a rank owns whole
//   blocks, so that a particle has the same lane on any
//             number of ranks
//   lane      a particle's place in its block, 0 to 15
//   slot      a direction in which bonds go to higher ends; each layer k has its own slots (stencil.h)
//   word      16 bits, a lane each: which bonds of one block and slot are alive
//   ghost     a copy of a neighbouring rank's particle
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/model/scenario.h"

namespace icebow {

constexpr int block = 16;  // particles of a row that share a word of bond bits
constexpr int ghost_blocks =
    2;  // copies of a neighbouring rank's particles at each end of a row: a block and its reach
constexpr int reach = 3;  // horizon / dx, rounded down: how many neighbours a row sees on each side

struct Lattice {
  int nx = 0, ny = 0, nz = 0;
  double dx = 0.0;  //!< spacing [m]
  double z0 = 0.0;  //!< height of the lowest layer's centres above the water level, sheet afloat [m]
  int first = 0;    // particles along x that a moving window has left astern
  // The ny columns are those at y > 0; as many more are their mirror images: column -1 - j that of j.
  bool half = false;

  int mirrored_columns() const { return half ? ny : 0; }
  int copies() const { return half ? 2 : 1; }  // of a particle in the whole sheet
  double width() const { return (ny + mirrored_columns()) * dx; }

  double x(int i) const { return (first + i + 0.5) * dx; }
  double y(int j) const { return (j + 0.5 - 0.5 * (ny - mirrored_columns())) * dx; }
  double z(int k) const { return z0 + k * dx; }
  int blocks() const { return (nx + block - 1) / block; }
  std::int64_t particles() const { return std::int64_t(nx) * ny * nz; }
  double particle_volume() const { return dx * dx * dx; }
  // Column-major number of a particle: the same on any number of ranks.
  std::int64_t id(int i, int j, int k) const { return (std::int64_t(j) * nz + k) * nx + i; }
};

// The sheet of a scenario; its draught is that of floating ice. Where a half model would cut a column in two
// the sheet is a column wider. Throws InputError for a sheet thinner than a layer.
Lattice make_lattice(const Scenario& scenario);

// Both halves of a half model's sheet: its column j is number j + mirrored_columns() there.
Lattice whole_sheet(const Lattice& lattice);

// Who owns what: a px x py grid of ranks over blocks (x) and columns (y).
struct Partition {
  int px = 1, py = 1;                                // ranks along x and y
  int block0 = 0, block1 = 0;                        // owned blocks [block0, block1)
  int j0 = 0, j1 = 0;                                // owned columns [j0, j1)
  int west = -1, east = -1, south = -1, north = -1;  // ranks at -x, +x, -y, +y; -1 = none
};

// Chooses the rank grid with the smallest halo, or with `along_x` ranks along x where that is not 0. Columns
// are dealt by what they cost, [j]; without costs all cost the same. Throws InputError where the sheet is too
// small for so many ranks.
Partition make_partition(const Lattice& lattice, int rank, int ranks, int along_x = 0,
                         const std::vector<double>& column_costs = {});

// What columns cost a step where a ship breaks ice, those far from its course costing 1: those within
// `half_breadth` of its middle line [m] have broken ice, which pieces and hull push.
std::vector<double> column_costs(const Lattice& lattice, double half_breadth);

// Addresses of one rank's padded rows.
struct Layout {
  Layout(const Lattice& lattice, const Partition& part);

  int nz;                 // layers
  int blocks;             // owned blocks
  int columns;            // owned columns (values of j)
  int i0, j0;             // global index of the first owned particle
  std::ptrdiff_t stride;  // floats from one row to the next
  std::size_t size;       // floats in one field, ghosts included

  // Which particle an address is: column and place along x count from the first owned one, as in row().
  struct Place {
    int jl, k, il;
  };
  Place place(std::size_t address) const {
    const int row = static_cast<int>(address / stride);
    return {row / nz - reach, row % nz, static_cast<int>(address % stride) - ghost_blocks * block};
  }

  // First owned particle of a row; jl = -reach .. columns + reach - 1 counts from the first owned column.
  std::size_t row(int jl, int k) const {
    return (std::size_t(jl + reach) * nz + k) * stride + ghost_blocks * block;
  }
};

}  // namespace icebow
