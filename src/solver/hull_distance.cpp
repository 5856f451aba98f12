#include "solver/hull_distance.h"

#include <array>
#include <cmath>

namespace icebow {
namespace {

// Both searches end here, so that they agree to the last bit.
ClosestPoint oriented(const TriangleSurface& surface, int triangle, const TrianglePoint& at, const Vec3& p) {
  ClosestPoint result;
  result.point = at.point;
  result.normal = surface.normal(triangle, at.feature);
  const double distance = std::sqrt(at.squared_distance);
  result.signed_distance = (p - at.point).dot(result.normal) < 0.0 ? -distance : distance;
  result.quad = surface.quad(triangle);
  return result;
}

Box common(const Box& a, const Box& b) {
  return {a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)};
}

// Edge of a square with the mean area of a panel.
double panel_size(const TriangleSurface& surface) {
  double area = 0.0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto [a, b, c] = surface.corners(t);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return std::sqrt(2.0 * area / static_cast<double>(std::max<std::size_t>(1, surface.size())));
}

// Cells of half a panel, between a quarter of the most cells (a coarse mesh wants a fine filter too) and the
// most.
CellGrid make_grid(const Box& box, double panel) {
  CellGrid grid;
  const Vec3 extent = box.upper - box.lower;
  if (extent.minCoeff() <= 0.0) return grid;
  const double finest = std::cbrt(extent.prod() / CellGrid::most_cells);
  double size = std::clamp(0.5 * panel, finest, finest * std::cbrt(4.0));
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

}  // namespace

ClosestPoint closest_brute_force(const TriangleSurface& surface, const Vec3& p) {
  int nearest = 0;
  TrianglePoint best = closest_on_triangle(surface.corners(0), p);
  for (std::size_t t = 1; t < surface.size(); ++t) {
    const TrianglePoint at = closest_on_triangle(surface.corners(t), p);
    if (at.squared_distance < best.squared_distance) best = at, nearest = static_cast<int>(t);
  }
  return oriented(surface, nearest, best, p);
}

HullDistance::HullDistance(const QuadMesh& mesh, const Box& region)
    : surface_(mesh),
      tree_(surface_),
      grid_(make_grid(common(bounding_box(mesh), region), panel_size(surface_))) {
  may_be_inside_.assign(1 + grid_.cells(), 0);
  seed_.assign(1 + grid_.cells(), -1);
  classify_cells();
}

void HullDistance::classify_cells() {
  int seed = -1;
  for (int iz = 0; iz < static_cast<int>(grid_.n[2]); ++iz)
    for (int iy = 0; iy < static_cast<int>(grid_.n[1]); ++iy) classify_row(iy, iz, seed);
}

// Signed distance changes by at most the way gone, so one query at a cell's centre settles its neighbours up
// to where the surface could be.
void HullDistance::classify_row(int iy, int iz, int& seed) {
  const int nx = static_cast<int>(grid_.n[0]), ny = static_cast<int>(grid_.n[1]);
  const double size = grid_.size;
  const double reach = 0.5 * std::sqrt(3.0) * size * 1.005;  // half a diagonal, and CellGrid's rounding
  for (int ix = 0; ix < nx;) {
    const Vec3 centre(grid_.lower[0] + (ix + 0.5) * size, grid_.lower[1] + (iy + 0.5) * size,
                      grid_.lower[2] + (iz + 0.5) * size);
    const NearestTriangle nearest = tree_.closest(centre, seed);
    seed = nearest.slot;
    const double distance = oriented(surface_, nearest.triangle, nearest.at, centre).signed_distance;
    const bool outside = distance > reach;
    // Half the way where the triangle is kept as a seed, which should not be far from the nearest.
    const double settled = outside ? distance - reach : 0.5 * (-distance - reach);
    const int next = std::min(nx, ix + 1 + std::max(0, static_cast<int>(settled / size)));
    const int row = 1 + nx * (iy + ny * iz);
    for (; ix < next; ++ix) {
      may_be_inside_[row + ix] = outside ? 0 : 1;
      seed_[row + ix] = outside ? -1 : seed;
    }
  }
}

ClosestPoint HullDistance::closest(const Vec3& p) const {
  const Eigen::Vector3f f = p.cast<float>();
  const NearestTriangle nearest = tree_.closest(p, seed_[grid_.cell(f.x(), f.y(), f.z())]);
  return oriented(surface_, nearest.triangle, nearest.at, p);
}

void HullDistance::find_inside(const float* x, const float* y, const float* z, std::size_t n,
                               const Vec3& hull_origin, std::vector<InsidePoint>& found) const {
  constexpr std::size_t block = 512;
  std::array<std::int32_t, block> cell;
  const Eigen::Vector3f shift = hull_origin.cast<float>();
  for (std::size_t begin = 0; begin < n; begin += block) {
    const std::size_t count = std::min(block, n - begin);
    for (std::size_t i = 0; i < count; ++i)
      cell[i] = grid_.cell(x[begin + i] - shift.x(), y[begin + i] - shift.y(), z[begin + i] - shift.z());
    for (std::size_t i = 0; i < count; ++i) {
      if (!may_be_inside_[cell[i]]) continue;
      const std::size_t index = begin + i;
      const Vec3 p = Vec3(x[index], y[index], z[index]) - hull_origin;
      const NearestTriangle nearest = tree_.closest(p, seed_[cell[i]]);
      const ClosestPoint at = oriented(surface_, nearest.triangle, nearest.at, p);
      if (at.signed_distance < 0.0) found.push_back({index, at});
    }
  }
}

std::size_t HullDistance::bytes() const {
  return surface_.bytes() + tree_.bytes() + may_be_inside_.size() * sizeof(may_be_inside_[0]) +
         seed_.size() * sizeof(seed_[0]);
}

}  // namespace icebow
