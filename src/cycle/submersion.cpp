#include "cycle/submersion.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "cycle/front_map.h"

namespace icebow::cycle {
namespace {

constexpr int columns = 120, rows = 80;
constexpr double covered_length = 0.7;  // of the ship's, from the stem (Lindqvist)
constexpr double plate_drag = 1.2;      // coefficient of a square plate across its way
constexpr double least_along =
    0.3;  // slower than this part of the ship's speed ice does not pile up: one layer
constexpr double flat = 1e-3,
                 edge_on = 20.0;  // slopes dx/d(y, z) of a wall across the course, of a side along it

struct Track {
  double depth = 0.0;   //!< where it leaves the bow [m]
  double along = 0.0;   //!< the ship's way until then [m]
  double rubbed = 0.0;  //!< integral of |n_z| over the way along the hull [m]
  double pushed = 0.0;  //!< integral of n_x^3 over the covered way [m]
  bool bottom = false;  // it leaves under the bottom
};

struct Slope {
  double y, z;
  bool hull;
};

// Gradient of x = f(y, z) in the cell of the point; no hull where a corner has none.
Slope slope(const FrontMap& map, double y, double z) {
  const double dy = map.y(1) - map.y(0), dz = map.dz();
  const int i = static_cast<int>(std::floor((y - map.y(0)) / dy)),
            k = static_cast<int>(std::floor((z - map.z(0)) / dz));
  if (i < 0 || k < 0 || i + 1 >= map.columns() || k + 1 >= map.rows()) return {0.0, 0.0, false};
  const double a = map.x(i, k), b = map.x(i + 1, k), c = map.x(i, k + 1), d = map.x(i + 1, k + 1);
  if (std::min({a, b, c, d}) == FrontMap::none) return {0.0, 0.0, false};
  const double u = (y - map.y(i)) / dy, v = (z - map.z(k)) / dz;
  return {((b - a) * (1.0 - v) + (d - c) * v) / dy, ((c - a) * (1.0 - u) + (d - b) * u) / dz, true};
}

// A floe pressed on by the hull goes along its normal; seen from the ship it goes down the gradient of
// x = f(y, z), square to the ship's sections, until it is under the bottom or beside.
Track follow(const FrontMap& map, double y) {
  const double dy = map.y(1) - map.y(0), lowest = map.z(0), stride = 0.4 * std::min(dy, map.dz());
  Track track;
  double z = -0.5 * map.dz();
  for (int k = 0; k < 20 * (rows + columns); ++k) {
    const Slope s = slope(map, y, z);
    const double steep = std::hypot(s.y, s.z);
    if (!s.hull || steep > edge_on) break;
    if (steep < flat) {  // a wall: straight down
      z = lowest;
      break;
    }
    const double size = std::sqrt(1.0 + steep * steep), forward = 1.0 / size, aft = steep / size;
    y -= stride * s.y / steep, z -= stride * s.z / steep;
    track.along += stride * steep;
    track.rubbed += stride * std::abs(s.z);
    track.pushed += stride * size * std::pow(forward, 3) / std::max(aft, least_along);
    if (z > 0.0) break;  // over the waterline again: it has gone up along a side that leans in
  }
  track.bottom = z < lowest + 2.0 * map.dz();
  track.depth = track.bottom ? -lowest : std::max(0.0, -z);
  return track;
}

struct Extent {
  double half_beam = 0.0, draught = 0.0;
};
Extent extent(const QuadMesh& hull) {
  Extent e;
  for (const Vec3& p : hull.points) {
    e.draught = std::max(e.draught, -p.z());
    if (p.z() <= 0.0) e.half_beam = std::max(e.half_beam, std::abs(p.y()));
  }
  return e;
}

}  // namespace

Submersion submersion(const QuadMesh& hull, const Ice& ice, double speed, double length) {
  Submersion result;
  const Extent e = extent(hull);
  if (!(e.draught > 0.0) || !(e.half_beam > 0.0)) return result;
  const double dy = 2.0 * e.half_beam / columns;
  std::vector<double> ys(columns);
  for (int i = 0; i < columns; ++i) ys[static_cast<std::size_t>(i)] = -e.half_beam + (i + 0.5) * dy;
  // The lowest row is a little above the bottom, whose panels are seen edge-on.
  const FrontMap map(hull, ys, -e.draught * (1.0 - 1e-6), e.draught / (rows - 1), rows);
  const double lift = (ice.rho_w - ice.rho) * gravity * ice.h;
  double width = 0.0, depth = 0.0, bottom = 0.0;
  for (double y : ys) {
    // Beside the column, away from the centre plane: the cell across a stem would be a wall.
    const double beside =
        std::clamp(y + std::copysign(1e-3 * dy, y), ys.front() + 1e-3 * dy, ys.back() - 1e-3 * dy);
    const Track track = follow(map, beside);
    const double under = track.bottom ? std::max(0.0, covered_length * length - track.along) : 0.0;
    result.potential += dy * lift * track.depth;
    result.friction += dy * ice.friction * lift * (track.rubbed + under);
    result.drag += dy * 0.5 * ice.rho_w * plate_drag * speed * speed * track.pushed;
    width += dy, depth += dy * track.depth, bottom += track.bottom ? dy : 0.0;
  }
  result.mean_depth = depth / width;
  result.under_bottom = bottom / width;
  return result;
}

}  // namespace icebow::cycle
