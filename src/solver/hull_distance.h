// Where a point lies relative to a rigid hull: the fast contact detection. The hull is fixed in its own
// frame; callers say where that frame's origin is.
//
// The surface is each quad split into two triangles along its shorter diagonal, so a warped quad is still
// watertight. Signed distance is negative inside; its sign comes from angle-weighted pseudo-normals
// (Baerentzen and Aanaes 2005), right at edges and corners of a closed mesh.
//
// Two filters make a query cheap whatever the number of panels. A uniform grid knows for each of its cells
// whether the whole cell is outside the hull: most particles are done after one table look-up. For the other
// cells it keeps a triangle close to the cell, whose distance is a tight first bound for the search in a tree
// of boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "base/quad_mesh.h"
#include "solver/cell_grid.h"
#include "solver/triangle_surface.h"
#include "solver/triangle_tree.h"

namespace icebow {

struct ClosestPoint {
  double signed_distance = 0.0;  //!< [m], negative inside
  Vec3 point = Vec3::Zero();     // on the surface
  Vec3 normal = Vec3::Zero();    // outward unit normal there, the pseudo-normal on an edge or corner
  int quad = -1;                 // of the mesh; the lowest number where several are equally near
};

// The reference: every triangle is asked.
ClosestPoint closest_brute_force(const TriangleSurface& surface, const Vec3& p);

// A point found inside the hull, by its number in the arrays asked.
struct InsidePoint {
  std::size_t index = 0;
  ClosestPoint closest;  // in the hull frame
};

class HullDistance {
 public:
  // Points of `region` (hull frame) will be asked for contact: the grid covers what the region and the hull's
  // bounding box share with 1 to 4 million cells (up to 20 MB), the finer the smaller the panels. Throws
  // InputError for a mesh that is not closed.
  HullDistance(const QuadMesh& mesh, const Box& region);

  // False at once for points that are certainly outside the hull or outside the region.
  bool may_be_inside(const Vec3& p) const {
    const Eigen::Vector3f f = p.cast<float>();
    return may_be_inside_[grid_.cell(f.x(), f.y(), f.z())] != 0;
  }
  // Exact closest point, equal to closest_brute_force bit for bit, for any point; fast where may_be_inside.
  ClosestPoint closest(const Vec3& p) const;

  // Appends those of n points (minus the hull's origin) in the region with a negative signed distance, in
  // order.
  void find_inside(const float* x, const float* y, const float* z, std::size_t n, const Vec3& hull_origin,
                   std::vector<InsidePoint>& found) const;

  const TriangleSurface& surface() const { return surface_; }
  const CellGrid& grid() const { return grid_; }
  std::size_t bytes() const;  // held by all tables

 private:
  void classify_cells();
  void classify_row(int iy, int iz, int& seed);

  TriangleSurface surface_;
  TriangleTree tree_;
  CellGrid grid_;
  // By cell number; entry 0, for points outside the grid, says outside.
  std::vector<std::uint8_t> may_be_inside_;
  std::vector<std::int32_t> seed_;  // slot of a near triangle
};

}  // namespace icebow
