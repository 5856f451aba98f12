#include "hullgen/import/chord_points.h"

#include <algorithm>

#include "geometry/triangles.h"

namespace icebow {
namespace {

constexpr double straight = 1e-4;  // of the edge's length: coordinates of four bytes are off by less
constexpr double same = 1e-9;      // of the mesh's size

bool between(const Vec3& v, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double length = edge.norm();
  if (!(length > 0.0)) return false;
  const double along = edge.dot(v - a) / length;
  return along > 0.0 && along < length && (v - a - along / length * edge).norm() <= straight * length;
}

void sort_by_x(std::vector<Vec3>& points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
}

bool one_at(const std::vector<Vec3>& sorted, const Vec3& p, double near) {
  auto k = std::lower_bound(sorted.begin(), sorted.end(), p.x() - near,
                            [](const Vec3& q, double value) { return q.x() < value; });
  for (; k != sorted.end() && k->x() <= p.x() + near; ++k)
    if ((*k - p).norm() <= near) return true;
  return false;
}

double near_in(const QuadMesh& mesh) {
  const Box box = bounding_box(mesh);
  return same * (box.upper - box.lower).maxCoeff();
}

}  // namespace

ChordPoints::ChordPoints(const QuadMesh& mesh, const std::vector<int>& points)
    : on_chord_(mesh.points.size(), 0), near_(points.empty() ? 0.0 : near_in(mesh)) {
  for (const int k : points) {
    on_chord_[static_cast<std::size_t>(k)] = 1;
    sorted_.push_back(mesh.points[static_cast<std::size_t>(k)]);
  }
  sort_by_x(sorted_);
}

bool ChordPoints::at(const Vec3& p) const {
  return one_at(sorted_, p, near_);
}

Polyline ChordPoints::without(const Polyline& line) const {
  if (sorted_.empty() || line.size() < 4) return line;
  Polyline kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool inner = k > 0 && k + 1 < line.size();
    if (inner && at(line[k]) && between(line[k], kept.back(), line[k + 1])) continue;
    kept.push_back(line[k]);
  }
  return kept;
}

std::vector<int> points_at(const QuadMesh& mesh, std::vector<Vec3> places) {
  std::vector<int> found;
  if (places.empty()) return found;
  sort_by_x(places);
  const double near = near_in(mesh);
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    if (one_at(places, mesh.points[k], near)) found.push_back(static_cast<int>(k));
  return found;
}

}  // namespace icebow
