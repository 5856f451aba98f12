#include "solver/output/particle_tiles.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace icebow {
namespace {

using Vec3f = Eigen::Vector3f;
using Place = std::array<int, 3>;

Vec3f position(const IceCloud& ice, std::size_t i) {
  return {ice.x[i], ice.y[i], ice.z[i]};
}
Vec3f displacement(const IceCloud& ice, std::size_t i) {
  return {ice.ux[i], ice.uy[i], ice.uz[i]};
}

// Particle at each place of the reference lattice.
class ReferenceLattice {
 public:
  explicit ReferenceLattice(const IceCloud& ice) : ice_(ice) {
    if (ice.x.empty()) return;
    const float largest = std::numeric_limits<float>::max();
    Vec3f lower = Vec3f::Constant(largest), upper = -lower;
    for (std::size_t i = 0; i < ice.x.size(); ++i) {
      const Vec3f X = position(ice, i) - displacement(ice, i);
      if (!X.allFinite()) continue;
      lower = lower.cwiseMin(X);
      upper = upper.cwiseMax(X);
    }
    lower_ = lower;
    double places = 1.0;
    for (int k = 0; k < 3; ++k) {
      const double n = std::floor((upper[k] - lower[k]) / ice.dx + 0.5) + 1.0;
      places *= n;
      n_[k] = n < 1e9 ? static_cast<int>(n) : 0;
    }
    // A window of a lattice is mostly full; anything else is not worth a table.
    if (!(places <= 1000.0 + 16.0 * static_cast<double>(ice.x.size()))) return;
    particle_.assign(static_cast<std::size_t>(places), -1);
    for (std::size_t i = 0; i < ice.x.size(); ++i)
      if (has_place(i)) particle_[number(place(i))] = static_cast<std::int32_t>(i);
  }

  bool known() const { return !particle_.empty(); }

  bool has_place(std::size_t i) const { return (position(ice_, i) - displacement(ice_, i)).allFinite(); }

  Place place(std::size_t i) const {
    const Vec3f X = position(ice_, i) - displacement(ice_, i) - lower_;
    Place p{};
    for (int k = 0; k < 3; ++k) p[k] = static_cast<int>(std::lround(X[k] / ice_.dx));
    return p;
  }

  // The neighbour one step along the axis if it is of the same piece of ice and still next to it, else -1.
  int companion(std::size_t i, Place p, int axis, int step) const {
    p[axis] += step;
    if (p[axis] < 0 || p[axis] >= n_[axis]) return -1;
    const int j = particle_[number(p)];
    if (j < 0 || ice_.piece[j] != ice_.piece[i]) return -1;
    const double stretch = (position(ice_, j) - position(ice_, i)).norm() / ice_.dx - 1.0;
    return std::abs(stretch) < 0.4 ? j : -1;
  }

 private:
  std::size_t number(const Place& p) const {
    return (static_cast<std::size_t>(p[2]) * n_[1] + p[1]) * n_[0] + p[0];
  }

  const IceCloud& ice_;
  Vec3f lower_;
  std::array<int, 3> n_{};
  std::vector<std::int32_t> particle_;
};

// Zero where there is no companion along the axis.
Vec3f edge(const IceCloud& ice, const ReferenceLattice& lattice, std::size_t i, const Place& place,
           int axis) {
  const int before = lattice.companion(i, place, axis, -1), after = lattice.companion(i, place, axis, 1);
  if (before >= 0 && after >= 0) return 0.5f * (position(ice, after) - position(ice, before));
  if (after >= 0) return position(ice, after) - position(ice, i);
  if (before >= 0) return position(ice, i) - position(ice, before);
  return Vec3f::Zero();
}

// Missing edges follow the known ones as a rigid cube would.
void complete(Tile& t, float dx) {
  const auto missing = [](const Vec3f& e) { return e.isZero(0.0f); };
  if (missing(t.x) && missing(t.y)) t.x = {dx, 0, 0};
  if (missing(t.x)) t.x = Vec3f(t.y.y(), -t.y.x(), 0);
  if (missing(t.y)) t.y = Vec3f(-t.x.y(), t.x.x(), 0);
  for (Vec3f* e : {&t.x, &t.y})
    if (missing(*e)) *e = e == &t.x ? Vec3f(dx, 0, 0) : Vec3f(0, dx, 0);  // the other one is upright
  if (missing(t.z)) t.z = dx * t.x.cross(t.y).stableNormalized();
}

}  // namespace

std::vector<Tile> particle_tiles(const IceCloud& ice) {
  const float dx = static_cast<float>(ice.dx);
  std::vector<Tile> tiles(ice.x.size(), Tile{{dx, 0, 0}, {0, dx, 0}, {0, 0, dx}});
  const ReferenceLattice lattice(ice);
  if (!lattice.known()) return tiles;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (ice.piece[i] < 0 || !lattice.has_place(i)) continue;
    const Place place = lattice.place(i);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3f& e = axis == 0 ? tiles[i].x : axis == 1 ? tiles[i].y : tiles[i].z;
      e = edge(ice, lattice, i, place, axis);
    }
    complete(tiles[i], dx);
  }
  return tiles;
}

}  // namespace icebow
