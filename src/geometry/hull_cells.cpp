#include "geometry/hull_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/cell_distances.h"
#include "geometry/clip_triangle.h"

namespace icebow {
namespace {

// A cell is taken this much larger on each side, in cell sizes: CellGrid may hand it points from next door.
constexpr double overlap = 2e-3;
// Of the largest coordinate: errors of a plane test in floats.
constexpr double plane_rounding = 4e-6;

enum NodeState : std::uint8_t { unknown, outside, touching, inside };

// Edge of a square with the mean area of a panel.
double panel_size(const TriangleSurface& surface) {
  double sum = 0.0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto [a, b, c] = surface.corners(t);
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return std::sqrt(2.0 * sum / static_cast<double>(std::max<std::size_t>(1, surface.size())));
}

CellGrid make_grid(const Box& box, double panel) {
  CellGrid grid;
  const Vec3 extent = box.upper - box.lower;
  if (extent.minCoeff() <= 0.0) return grid;
  const double finest = std::cbrt(extent.prod() / CellGrid::most_cells);
  // A coarse mesh wants fine cells too: they filter.
  double size = std::clamp(0.7 * panel, finest, finest * std::cbrt(4.0));
  const auto cells_along = [&](int k) { return std::ceil(extent[k] / size + 0.01); };
  while (cells_along(0) * cells_along(1) * cells_along(2) > CellGrid::most_cells) size *= 1.02;
  grid.size = static_cast<float>(size);
  grid.per_size = 1.0f / grid.size;
  for (int k = 0; k < 3; ++k) {
    // Room for rounding at the faces of the box.
    grid.lower[k] = static_cast<float>(box.lower[k] - 0.005 * size);
    grid.n[k] = static_cast<float>(cells_along(k));
  }
  return grid;
}

class Builder {
 public:
  Builder(const TriangleSurface& surface, const TriangleTree& tree, const Box& box)
      : surface_(surface), tree_(tree) {
    cells_.grid = make_grid(box, panel_size(surface));
    for (int k = 0; k < 3; ++k) n_[k] = static_cast<int>(cells_.grid.n[k]);
    lower_ = Vec3(cells_.grid.lower[0], cells_.grid.lower[1], cells_.grid.lower[2]);
    size_ = cells_.grid.size;
    reach_ = (0.5 + overlap) * std::sqrt(3.0) * size_;
    const double largest = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    plane_margin_ = plane_rounding * (largest + size_);
    cells_.kind.assign(1 + cells_.grid.cells(), 0);
    cells_.away.assign(cells_.kind.size(), 0);
  }

  HullCells build() {
    if (cells_.grid.cells() == 0) return std::move(cells_);
    find_surface_cells();
    for (std::size_t c = 0; c < seeds_.size(); ++c) list_candidates(c);
    bound_by_planes();
    for (int iz = 0; iz < n_[2]; ++iz)
      for (int iy = 0; iy < n_[1]; ++iy) fill_row(iy, iz);
    find_away();
    return std::move(cells_);
  }

 private:
  struct Seed {
    double area = 0.0;  // of the surface in the cell
    Vec3 normal = Vec3::Zero();
    double largest = 0.0;
    int slot = -1;  // of the triangle with the largest part in the cell
    double offset = -std::numeric_limits<double>::infinity();
  };

  std::int32_t& kind(int ix, int iy, int iz) { return cells_.kind[1 + ix + n_[0] * (iy + n_[1] * iz)]; }
  Vec3 node(int ix, int iy, int iz) const { return lower_ + size_ * Vec3(ix, iy, iz); }

  // Calls visit(part, i) for each layer of cells along the axis that the polygon enters, with its part in the
  // layer.
  template <class Visit>
  void slice(const Polygon& polygon, int axis, const Visit& visit) const {
    const double from = (polygon.lower(axis) - lower_[axis]) / size_ - 2.0 * overlap;
    const double to = (polygon.upper(axis) - lower_[axis]) / size_ + 2.0 * overlap;
    const int last = static_cast<int>(std::min(n_[axis] - 1.0, std::floor(to)));
    for (int i = static_cast<int>(std::max(0.0, std::floor(from))); i <= last; ++i) {
      Polygon part = polygon;
      clip(part, axis, lower_[axis] + (i - overlap) * size_, lower_[axis] + (i + 1 + overlap) * size_);
      if (part.size > 0) visit(part, i);
    }
  }

  // Calls visit(part, ix, iy, iz) for every cell a triangle passes through, with its part in the cell.
  template <class Visit>
  void rasterise(const Corners& triangle, const Visit& visit) const {
    slice(Polygon(triangle), 2, [&](const Polygon& layer, int iz) {
      slice(layer, 1, [&](const Polygon& row, int iy) {
        slice(row, 0, [&](const Polygon& part, int ix) { visit(part, ix, iy, iz); });
      });
    });
  }

  void find_surface_cells() {
    for (int slot = 0; slot < tree_.size(); ++slot) {
      const int triangle = tree_.triangle(slot);
      const Vec3& normal = surface_.normal(triangle, Feature::face);
      rasterise(surface_.corners(triangle), [&](const Polygon& part, int ix, int iy, int iz) {
        std::int32_t& k = kind(ix, iy, iz);
        if (k == 0) add_surface_cell(ix, iy, iz, k);
        Seed& seed = seeds_[k - 1];
        const double a = area(part);
        seed.normal += a * normal;
        if (seed.slot < 0 || a > seed.largest) seed.slot = slot, seed.largest = a;
      });
    }
    for (Seed& seed : seeds_)
      seed.normal = seed.normal.norm() > 0.0 ? Vec3(seed.normal.normalized()) : Vec3::Zero();
  }

  void add_surface_cell(int ix, int iy, int iz, std::int32_t& k) {
    const Vec3 centre = node(ix, iy, iz) + Vec3::Constant(0.5 * size_);
    SurfaceCell cell;
    for (int axis = 0; axis < 3; ++axis) cell.centre[axis] = static_cast<float>(centre[axis]);
    cells_.surface.push_back(cell);
    seeds_.emplace_back();
    k = static_cast<std::int32_t>(seeds_.size());
  }

  // With D the centre's distance from the hull and r half a diagonal, a point of the cell is within D + r of
  // the hull, so its closest triangle is within D + 2 r of the centre.
  void list_candidates(std::size_t c) {
    SurfaceCell& cell = cells_.surface[c];
    const Vec3 centre(cell.centre[0], cell.centre[1], cell.centre[2]);
    const double D = std::sqrt(tree_.closest(centre, seeds_[c].slot).at.squared_distance);
    tree_.within(centre, (D + 2.0 * reach_) * (1.0 + 1e-6), near_);
    std::sort(near_.begin(), near_.end(), [](const TriangleTree::Near& l, const TriangleTree::Near& r) {
      return l.distance < r.distance;
    });
    cell.all_kept = near_.size() <= HullCells::most_candidates;
    if (!cell.all_kept) near_.resize(HullCells::most_candidates);
    cell.first = static_cast<std::int32_t>(cells_.candidates.size());
    cell.count = static_cast<std::int32_t>(near_.size());
    for (const TriangleTree::Near& n : near_)
      cells_.candidates.push_back({n.slot, std::nextafter(static_cast<float>(n.distance), -1.0f)});
  }

  // Where a linear function is largest over the part of the hull in a cell, there is a corner of the
  // surface's part in the cell or a corner of the cell inside the hull.
  void bound_by_planes() {
    for (int slot = 0; slot < tree_.size(); ++slot)
      rasterise(surface_.corners(tree_.triangle(slot)), [&](const Polygon& part, int ix, int iy, int iz) {
        Seed& seed = seeds_[kind(ix, iy, iz) - 1];
        for (int k = 0; k < part.size; ++k)
          seed.offset = std::max(seed.offset, seed.normal.dot(part.corner[k]));
      });
    node_state_.assign((n_[0] + 1) * static_cast<std::size_t>(n_[1] + 1) * (n_[2] + 1), unknown);
    for (int iz = 0; iz < n_[2]; ++iz)
      for (int iy = 0; iy < n_[1]; ++iy)
        for (int ix = 0; ix < n_[0]; ++ix)
          if (const std::int32_t k = kind(ix, iy, iz)) finish_plane(ix, iy, iz, k);
  }

  void finish_plane(int ix, int iy, int iz, std::int32_t k) {
    Seed& seed = seeds_[k - 1];
    for (int corner = 0; corner < 8; ++corner) {
      const int cx = ix + (corner & 1), cy = iy + (corner >> 1 & 1), cz = iz + (corner >> 2);
      const double reach = seed.normal.dot(node(cx, cy, cz)) + overlap * size_ * seed.normal.cwiseAbs().sum();
      if (reach > seed.offset && state(cx, cy, cz, k) != outside) seed.offset = reach;
    }
    SurfaceCell& cell = cells_.surface[k - 1];
    cell.offset = std::numeric_limits<float>::infinity();
    if (seed.normal.isZero(0.0)) return;
    for (int axis = 0; axis < 3; ++axis) cell.normal[axis] = static_cast<float>(seed.normal[axis]);
    cell.offset = static_cast<float>(seed.offset + plane_margin_);
  }

  // Of a node of a cell of kind k; touching where the corner of the wider cell may be on the other side.
  NodeState state(int ix, int iy, int iz, std::int32_t k) {
    std::uint8_t& known = node_state_[ix + (n_[0] + 1) * (iy + static_cast<std::size_t>(n_[1] + 1) * iz)];
    if (known == unknown) {
      const Vec3 p = node(ix, iy, iz);
      const NearestTriangle nearest = cells_.closest(tree_, k, p);
      const bool is_inside =
          (p - nearest.at.point).dot(surface_.normal(nearest.triangle, nearest.at.feature)) < 0.0;
      const bool near = nearest.at.squared_distance < std::pow(4.0 * overlap * size_, 2);
      known = is_inside ? inside : near ? touching : outside;
    }
    return static_cast<NodeState>(known);
  }

  // Cells that the surface does not pass through are on the side of the node they share with the cell before.
  void fill_row(int iy, int iz) {
    bool is_inside = false;
    for (int ix = 0; ix < n_[0]; ++ix) {
      std::int32_t& k = kind(ix, iy, iz);
      if (k > 0) continue;
      const std::int32_t before = ix > 0 ? kind(ix - 1, iy, iz) : 0;
      if (ix == 0 || before > 0) is_inside = state(ix, iy, iz, before) == inside;
      if (is_inside) k = ~nearby_slot(ix, iy, iz);
    }
  }

  // Some triangle not far away: that of a neighbour that has one.
  int nearby_slot(int ix, int iy, int iz) {
    const std::int32_t beside = iy > 0 ? kind(ix, iy - 1, iz) : 0, before = ix > 0 ? kind(ix - 1, iy, iz) : 0;
    const std::int32_t k = beside != 0 ? beside : before;
    if (k > 0) return seeds_[k - 1].slot;
    return k < 0 ? ~k : tree_.closest(node(ix, iy, iz)).slot;
  }

  void find_away() {
    std::vector<std::uint8_t> marked(cells_.kind.size() - 1);
    std::transform(cells_.kind.begin() + 1, cells_.kind.end(), marked.begin(),
                   [](std::int32_t k) { return std::uint8_t(k != 0); });
    const std::vector<std::uint8_t> away = cell_distances(n_, marked);
    std::copy(away.begin(), away.end(), cells_.away.begin() + 1);
  }

  const TriangleSurface& surface_;
  const TriangleTree& tree_;
  HullCells cells_;
  int n_[3];
  Vec3 lower_;
  double size_, reach_, plane_margin_;
  std::vector<Seed> seeds_;  // by surface cell
  std::vector<std::uint8_t> node_state_;
  std::vector<TriangleTree::Near> near_;
};

}  // namespace

NearestTriangle HullCells::closest(const TriangleTree& tree, std::int32_t kind_of_cell, const Vec3& p) const {
  if (kind_of_cell <= 0) return tree.closest(p, kind_of_cell < 0 ? ~kind_of_cell : -1);
  const SurfaceCell& cell = surface[kind_of_cell - 1];
  const double from_centre = (p - Vec3(cell.centre[0], cell.centre[1], cell.centre[2])).norm();
  NearestTriangle best = TriangleTree::no_triangle();
  for (int k = cell.first; k < cell.first + cell.count; ++k) {
    // No triangle from here on is nearer to p than this, with room for rounding.
    const double bound = candidates[k].distance - from_centre * (1.0 + 1e-6);
    if (bound > 0.0 && bound * bound > best.at.squared_distance) return best;
    tree.improve(candidates[k].slot, p, best);
  }
  return cell.all_kept ? best : tree.closest(p, best.slot);
}

namespace {

// Of a cell: where a point lies in it along each axis, in cells; and how far it is to the nearest side.
struct InCell {
  float part[3], to_side = 0.5F;
  InCell(const CellGrid& grid, const float (&p)[3]) {
    for (int c = 0; c < 3; ++c) {
      const float at = (p[c] - grid.lower[c]) * grid.per_size;
      part[c] = at - std::floor(at);
      to_side = std::min({to_side, part[c], 1.0F - part[c]});
    }
  }
  // To the cell beside it in this direction, a step of -1, 0 or 1 along each axis.
  float to(int dx, int dy, int dz) const { return std::sqrt(gap2(0, dx) + gap2(1, dy) + gap2(2, dz)); }

 private:
  float gap2(int axis, int step) const {
    const float gap = step == 0 ? 0.0F : step < 0 ? part[axis] : 1.0F - part[axis];
    return gap * gap;
  }
};

constexpr float doubt = 0.01F;  // a cell may have been mistaken for the next (CellGrid)

// How far from a point it is at least to what may be inside in its cell and the 26 around [m]. No more is
// known than that the next cells may be inside.
float clearance_around(const HullCells& cells, std::int32_t cell, const InCell& in, const float (&p)[3]) {
  const CellGrid& grid = cells.grid;
  const int nx = static_cast<int>(grid.n[0]), ny = static_cast<int>(grid.n[1]),
            nz = static_cast<int>(grid.n[2]);
  const int ix = (cell - 1) % nx, iy = (cell - 1) / nx % ny, iz = (cell - 1) / nx / ny;
  float least = (1.0F + in.to_side) * grid.size;
  for (int dz = iz > 0 ? -1 : 0; dz <= (iz < nz - 1 ? 1 : 0); ++dz) {
    for (int dy = iy > 0 ? -1 : 0; dy <= (iy < ny - 1 ? 1 : 0); ++dy) {
      for (int dx = ix > 0 ? -1 : 0; dx <= (ix < nx - 1 ? 1 : 0); ++dx) {
        const std::int32_t kind = cells.kind[cell + dx + nx * (dy + ny * dz)];
        if (kind == 0) continue;
        const float beyond = cells.beyond_plane(kind, p[0], p[1], p[2]);
        least = std::min(least, std::max(in.to(dx, dy, dz) * grid.size, beyond));
      }
    }
  }
  return std::max(0.0F, least - doubt * grid.size);
}

}  // namespace

float HullCells::clearance(std::int32_t cell, float x, float y, float z) const {
  constexpr float much = 0.3F;  // of a cell's size: enough not to look around
  const float p[3] = {x, y, z};
  if (cell > 0) {
    const InCell in(grid, p);
    const float steps = float(away[cell]) - 1.0F + in.to_side - doubt;
    return steps > much ? steps * grid.size : clearance_around(*this, cell, in, p);
  }
  float beyond = 0.0F;  // the grid, along some axis
  for (int c = 0; c < 3; ++c) {
    const float upper = grid.lower[c] + grid.n[c] * grid.size;
    beyond = std::max({beyond, grid.lower[c] - p[c], p[c] - upper});
  }
  return std::max(0.0F, beyond - doubt * grid.size);
}

std::size_t HullCells::bytes() const {
  return away.capacity() + kind.capacity() * sizeof(kind[0]) + surface.capacity() * sizeof(SurfaceCell) +
         candidates.capacity() * sizeof(Candidate);
}

HullCells make_hull_cells(const TriangleSurface& surface, const TriangleTree& tree, const Box& box) {
  return Builder(surface, tree, box).build();
}

}  // namespace icebow
