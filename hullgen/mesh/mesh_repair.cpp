#include "hullgen/mesh/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_map>

#include "base/errors.h"
#include "base/text.h"
#include "hullgen/mesh/panel_orientation.h"

namespace icebow {
namespace {

using Quad = std::array<int, 4>;

// Each point's number after joining: the first of those near it. A uniform grid of cells, in each the points
// kept so far.
class Joiner {
 public:
  explicit Joiner(double distance) : distance_(distance) {}

  int number(const Vec3& p) {
    const std::array<std::int64_t, 3> cell = cell_of(p);
    for (int k = 0; k < 27; ++k) {
      const auto found = cells_.find(key(cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1));
      if (found == cells_.end()) continue;
      for (const int near : found->second)
        if ((kept[near] - p).norm() <= distance_) return near;
    }
    cells_[key(cell[0], cell[1], cell[2])].push_back(static_cast<int>(kept.size()));
    kept.push_back(p);
    return static_cast<int>(kept.size()) - 1;
  }

  std::vector<Vec3> kept;

 private:
  std::array<std::int64_t, 3> cell_of(const Vec3& p) const {
    const auto along = [&](int k) { return static_cast<std::int64_t>(std::floor(p[k] / distance_)); };
    return {along(0), along(1), along(2)};
  }
  // Other cells may share a key: they only cost time.
  static std::uint64_t key(std::int64_t i, std::int64_t j, std::int64_t k) {
    return static_cast<std::uint64_t>(i) * 73856093u ^ static_cast<std::uint64_t>(j) * 19349663u ^
           static_cast<std::uint64_t>(k) * 83492791u;
  }

  double distance_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// The corners once each, in order; less than three where the panel has no area.
std::vector<int> distinct(const Quad& q) {
  std::vector<int> corners;
  for (int k = 0; k < 4; ++k)
    if (q[k] != q[(k + 1) % 4]) corners.push_back(q[k]);
  const bool pinched = std::set<int>(corners.begin(), corners.end()).size() < corners.size();
  return pinched ? std::vector<int>() : corners;
}

Vec3 twice_area(const std::vector<Vec3>& p, int a, int b, int c) {
  return (p[b] - p[a]).cross(p[c] - p[a]);
}

// Along its shorter diagonal, as contact detection takes it, but not along the other.
bool is_folded(const std::vector<Vec3>& p, const Quad& q) {
  const bool first = (p[q[0]] - p[q[2]]).squaredNorm() <= (p[q[1]] - p[q[3]]).squaredNorm();
  const double along02 = twice_area(p, q[0], q[1], q[2]).dot(twice_area(p, q[0], q[2], q[3]));
  const double along13 = twice_area(p, q[1], q[2], q[3]).dot(twice_area(p, q[1], q[3], q[0]));
  return first ? along02 < 0.0 && along13 > 0.0 : along13 < 0.0 && along02 > 0.0;
}

void add_panel(QuadMesh& mesh, const std::vector<int>& c, Patch patch, MeshRepairs& repairs) {
  const Quad q = {c[0], c[1], c[2], c.back()};
  if (c.size() == 3 || !is_folded(mesh.points, q)) {
    mesh.quads.push_back(q);
    mesh.patch.push_back(patch);
    return;
  }
  const bool along13 = (mesh.points[q[0]] - mesh.points[q[2]]).squaredNorm() <=
                       (mesh.points[q[1]] - mesh.points[q[3]]).squaredNorm();
  const int k = along13 ? 1 : 0;  // the other diagonal than the shorter
  mesh.quads.push_back({q[k], q[k + 1], q[k + 2], q[k + 2]});
  mesh.quads.push_back({q[k], q[k + 2], q[(k + 3) % 4], q[(k + 3) % 4]});
  mesh.patch.insert(mesh.patch.end(), 2, patch);
  ++repairs.split;
}

QuadMesh joined(const QuadMesh& mesh, MeshRepairs& repairs) {
  Joiner joiner(joining_distance(mesh));
  std::vector<int> number;
  for (const Vec3& p : mesh.points) number.push_back(joiner.number(p));
  repairs.joined += static_cast<int>(mesh.points.size() - joiner.kept.size());
  QuadMesh result;
  result.points = joiner.kept;
  std::set<std::vector<int>> there;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    Quad q = mesh.quads[k];
    for (int& corner : q) corner = number[corner];
    const std::vector<int> corners = distinct(q);
    std::vector<int> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (corners.size() < 3) {
      ++repairs.collapsed;
    } else if (!there.insert(sorted).second) {
      ++repairs.repeated;
    } else {
      add_panel(result, corners, mesh.patch[k], repairs);
    }
  }
  return result;
}

}  // namespace

QuadMesh without_unused_points(const QuadMesh& mesh) {
  QuadMesh result = mesh;
  std::vector<int> number(mesh.points.size(), -1);
  std::vector<Vec3> used;
  for (auto& q : result.quads)
    for (int& corner : q) {
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(used.size());
        used.push_back(mesh.points[corner]);
      }
      corner = number[corner];
    }
  result.points = std::move(used);
  return result;
}

std::vector<std::string> in_words(const MeshRepairs& r) {
  std::vector<std::string> words;
  const auto say = [&](int n, const char* one, const char* many) {
    if (n > 0) words.push_back(text(n == 1 ? one : many, n));
  };
  say(r.mirrored, "%d panel was mirrored to the other side", "%d panels were mirrored to the other side");
  say(r.split, "%d panel was split into triangles", "%d panels were split into triangles");
  say(r.joined, "%d point was joined to one in the same place",
      "%d points were joined to others in the same place");
  say(r.collapsed, "%d panel without area was dropped", "%d panels without area were dropped");
  say(r.repeated, "%d panel that was there twice was dropped",
      "%d panels that were there twice were dropped");
  say(r.turned, "%d panel was turned outward", "%d panels were turned outward");
  if (r.components > 1) words.push_back(text("it consists of %d closed surfaces", r.components));
  return words;
}

double joining_distance(const QuadMesh& mesh) {
  const Box box = bounding_box(mesh);
  return 1e-6 * (box.upper - box.lower).maxCoeff();
}

QuadMesh with_mirror_image(const QuadMesh& half, const std::string& path, MeshRepairs& repairs) {
  const double distance = joining_distance(half);
  const Box box = bounding_box(half);
  if (box.lower.y() < -distance && box.upper.y() > distance)
    throw InputError(
        text("%s: reaches from y = %g to %g m across the file's centre plane, so it has both sides already: "
             "drop \"mirror\", or export one side",
             path.c_str(), box.lower.y(), box.upper.y()));
  QuadMesh result;
  result.points = half.points;
  for (Vec3& p : result.points)
    if (std::abs(p.y()) <= distance) p.y() = 0.0;
  const int n = static_cast<int>(result.points.size());
  for (int k = 0; k < n; ++k)
    result.points.push_back(result.points[k].cwiseProduct(Vec3(1.0, -1.0, 1.0)).eval());
  for (std::size_t k = 0; k < half.quads.size(); ++k) {
    const Quad& q = half.quads[k];
    if (std::all_of(q.begin(), q.end(), [&](int corner) { return result.points[corner].y() == 0.0; }))
      continue;
    result.quads.push_back(q);
    result.quads.push_back({q[3] + n, q[2] + n, q[1] + n, q[0] + n});
    result.patch.insert(result.patch.end(), 2, half.patch[k]);
    ++repairs.mirrored;
  }
  return result;
}

QuadMesh repaired(const QuadMesh& mesh, const std::string& path, MeshRepairs& repairs) {
  QuadMesh result = without_unused_points(joined(mesh, repairs));
  if (result.quads.empty()) throw InputError(path + ": has no panel with an area");
  repairs.components = turn_outward(result, path, repairs.turned);
  return result;
}

}  // namespace icebow
