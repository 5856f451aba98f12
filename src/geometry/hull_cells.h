// What each cell of a uniform grid knows about the hull: enough to answer most questions without a search.
//
// A cell is outside the hull, inside it, or the surface passes through it. A surface cell keeps a plane with
// no part of the hull beyond it, so that on smooth hulls only points within a hair of the surface are asked
// further, and the triangles that can be closest to a point of the cell, in the order of their distance from
// its centre.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/cell_grid.h"
#include "geometry/triangle_surface.h"
#include "geometry/triangle_tree.h"

namespace icebow {

struct SurfaceCell {
  float normal[3] = {0, 0, 0};
  float offset =
      0;  // normal . x <= offset wherever the hull is inside this cell; infinite: no such plane is known
  float centre[3] = {0, 0, 0};
  std::int32_t first = 0, count = 0;  // of its candidates
  bool all_kept = true;               // false: more triangles than the candidates could be closest
};

struct Candidate {
  std::int32_t slot;  // in the tree
  float distance;     // from the cell's centre, rounded down [m]
};

struct HullCells {
  // Candidates beyond these would be needed only by points far from the surface.
  static constexpr int most_candidates = 16;

  CellGrid grid;
  // By cell number; entry 0 stands for points beyond the grid. 0: outside the hull; k > 0: surface[k - 1];
  // k < 0: inside, with the tree slot ~k near by.
  std::vector<std::int32_t> kind;
  // Likewise: steps to the nearest cell that is not outside, cell_distances.h; 0 for entry 0.
  std::vector<std::uint8_t> away;
  std::vector<SurfaceCell> surface;
  std::vector<Candidate> candidates;

  std::int32_t kind_at(float x, float y, float z) const { return kind[grid.cell(x, y, z)]; }
  // False only for points that are certainly outside the hull or the grid.
  bool may_be_inside(std::int32_t kind_of_cell, float x, float y, float z) const {
    if (kind_of_cell <= 0) return kind_of_cell < 0;
    return beyond_plane(kind_of_cell, x, y, z) <= 0.0F;
  }
  // From the plane of a cell that is not outside to a point outwards [m], or less; minus infinity inside.
  float beyond_plane(std::int32_t kind_of_cell, float x, float y, float z) const {
    if (kind_of_cell <= 0) return -std::numeric_limits<float>::infinity();
    const SurfaceCell& cell = surface[kind_of_cell - 1];
    return cell.normal[0] * x + cell.normal[1] * y + cell.normal[2] * z - cell.offset;
  }
  // How far from a point until one may be inside [m], at least; 0 where that is little or nothing.
  float clearance(std::int32_t cell, float x, float y, float z) const;
  // The closest triangle, exact for any p whose cell is of this kind.
  NearestTriangle closest(const TriangleTree& tree, std::int32_t kind_of_cell, const Vec3& p) const;

  std::size_t bytes() const;
};

// Cells over `box`, the common part of the hull's bounding box and the region asked about: 1 to 4 million,
// 0.7 panels wide where that lies between. An empty box gives no cells.
HullCells make_hull_cells(const TriangleSurface& surface, const TriangleTree& tree, const Box& box);

}  // namespace icebow
