// Where a point lies relative to a rigid hull: the fast contact detection. The hull is fixed in its own
// frame; callers say where that frame's origin is.
//
// The surface is each quad split into two triangles along its shorter diagonal, so a warped quad is still
// watertight. Signed distance is negative inside; its sign comes from angle-weighted pseudo-normals
// (Baerentzen and Aanaes 2005), right at edges and corners of a closed mesh.
//
// Two structures make a query cheap whatever the number of panels: a uniform grid whose cells know whether
// they are outside, inside or crossed by the surface, and which triangles matter to them (hull_cells.h), and
// a tree of boxes for the few points far from the surface (triangle_tree.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/hull_cells.h"
#include "geometry/quad_mesh.h"
#include "geometry/triangle_surface.h"
#include "geometry/triangle_tree.h"

namespace icebow {

struct ClosestPoint {
  double signed_distance = 0.0;  //!< [m], negative inside
  Vec3 point = Vec3::Zero();     // on the surface
  Vec3 normal = Vec3::Zero();    // outward unit normal there, the pseudo-normal on an edge or corner
  int quad = -1;                 // of the mesh; the lowest number where several are equally near
};

// The reference: every triangle is asked.
ClosestPoint closest_brute_force(const TriangleSurface& surface, const Vec3& p);

class HullDistance {
 public:
  // Points of `region` (hull frame) will be asked for contact: the grid covers what the region and the hull's
  // bounding box share with 1 to 4 million cells, the finer the smaller the panels. Memory: 5 bytes a cell,
  // up to 176 bytes a cell that the surface crosses, about 500 bytes a quad. Throws InputError for a mesh
  // that is not closed.
  HullDistance(const QuadMesh& mesh, const Box& region);

  // What is known of a point without a search.
  struct Outlook {
    bool may_be_inside;  //!< false at once for what is certainly outside the hull or outside the region
    float clearance;     //!< no point nearer than this may be inside [m]; 0 if this one may be
  };
  Outlook outlook(const Vec3& p) const {
    const Eigen::Vector3f f = p.cast<float>();
    const std::int32_t cell = cells_.grid.cell(f.x(), f.y(), f.z());
    return {cells_.may_be_inside(cells_.kind[cell], f.x(), f.y(), f.z()),
            cells_.clearance(cell, f.x(), f.y(), f.z())};
  }
  // Exact closest point, equal to closest_brute_force bit for bit, for any point; fast near and inside the
  // hull.
  ClosestPoint closest(const Vec3& p) const;

  // What a search for a point that moves has found: the triangles of which one is the nearest as long as the
  // point has not moved by more than `rest` [m], and one of the first `leaders` of them as long as it has not
  // moved by more than `lead`. None: too many to be kept.
  struct Known {
    static constexpr int most = 12;  // twice as many as meet at a corner of the mesh
    std::array<std::int32_t, most> slot;
    std::int32_t count = 0, leaders = 0;
    float rest = 0.0F, lead = 0.0F;
    void moved(float way) {
      rest -= way;
      lead -= way;
    }
  };
  // The same to the bit; near the hull outlook() says nothing that it does not. Callers say how far the point
  // has moved since the last call.
  ClosestPoint closest(const Vec3& p, Known& known) const;
  // Whether contact is looked for here at all.
  bool in_region(const Vec3& p) const {
    const Eigen::Vector3f f = p.cast<float>();
    return cells_.grid.cell(f.x(), f.y(), f.z()) != 0;
  }

  const TriangleSurface& surface() const { return surface_; }
  const CellGrid& grid() const { return cells_.grid; }
  std::size_t bytes() const { return surface_.bytes() + tree_.bytes() + cells_.bytes(); }

 private:
  NearestTriangle nearest(const Vec3& p) const;
  void keep(const Vec3& p, double distance, Known& known) const;
  NearestTriangle compete(const Vec3& p, Known& known) const;

  TriangleSurface surface_;
  TriangleTree tree_;
  HullCells cells_;
};

}  // namespace icebow
