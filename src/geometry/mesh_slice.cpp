#include "geometry/mesh_slice.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace icebow {
namespace {

using EdgeKey = std::uint64_t;

EdgeKey edge_key(int a, int b) {
  return static_cast<EdgeKey>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

Vec3 crossing(const Vec3& p, const Vec3& q, int axis, double at) {
  Vec3 point = p + (at - p[axis]) / (q[axis] - p[axis]) * (q - p);
  point[axis] = at;
  return point;
}

void append(Polyline& line, const Vec3& point) {
  if (line.empty() || (line.back() - point).norm() > 1e-9) line.push_back(point);
}

}  // namespace

std::vector<Polyline> slice(const QuadMesh& mesh, int axis, double at) {
  const auto above = [&](int i) { return mesh.points[i][axis] >= at; };
  // Going round a panel, the cut enters through an edge that rises and leaves through the next that falls;
  // the neighbour sees the same edges the other way round, so each cut edge has one successor.
  std::unordered_map<EdgeKey, EdgeKey> next;
  std::unordered_map<EdgeKey, Vec3> points;
  for (const auto& q : mesh.quads) {
    for (int k = 0; k < 4; ++k) {
      if (above(q[k]) || !above(q[(k + 1) % 4])) continue;
      int leave = k + 1;
      while (!above(q[leave % 4]) || above(q[(leave + 1) % 4])) ++leave;
      const EdgeKey from = edge_key(q[k], q[(k + 1) % 4]);
      next[from] = edge_key(q[leave % 4], q[(leave + 1) % 4]);
      points[from] = crossing(mesh.points[q[k]], mesh.points[q[(k + 1) % 4]], axis, at);
    }
  }
  std::vector<Polyline> loops;
  while (!next.empty()) {
    Polyline loop;
    for (auto step = next.begin(); step != next.end();) {
      append(loop, points.at(step->first));
      const EdgeKey to = step->second;
      next.erase(step);
      step = next.find(to);
    }
    append(loop, loop.front());
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Polyline> clipped(const Polyline& line, int axis, double lower) {
  std::vector<Polyline> parts;
  Polyline part;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool inside = line[k][axis] >= lower;
    const bool was_inside = k > 0 && line[k - 1][axis] >= lower;
    if (k > 0 && inside != was_inside) append(part, crossing(line[k - 1], line[k], axis, lower));
    if (inside) append(part, line[k]);
    if (!inside && !part.empty()) parts.push_back(std::move(part)), part.clear();
  }
  if (part.size() > 1) parts.push_back(std::move(part));
  // A closed line that starts inside comes out in two pieces: join the last to the first.
  if (parts.size() > 1 && (parts.back().back() - parts.front().front()).norm() <= 1e-9) {
    parts.back().insert(parts.back().end(), parts.front().begin() + 1, parts.front().end());
    parts.front() = std::move(parts.back());
    parts.pop_back();
  }
  return parts;
}

}  // namespace icebow
