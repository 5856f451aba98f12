#include "hullgen/mesh/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>

#include "base/errors.h"
#include "base/text.h"
#include "geometry/triangles.h"
#include "hullgen/mesh/mesh_edges.h"
#include "hullgen/mesh/mesh_holes.h"
#include "hullgen/mesh/mesh_seams.h"
#include "hullgen/mesh/mesh_visibility.h"
#include "hullgen/mesh/panel_orientation.h"

namespace icebow {
namespace {

using Quad = std::array<int, 4>;

constexpr double off_centre =
    1e-3;  // of the breadth: how far from the centre plane a half hull's rim may lie
constexpr double widest_gap = 1e-3;  // of the mesh's length: what is closed as a seam; wider ones are holes

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

// A triangle lower than this has no area that matters, and no normal.
bool has_height(const std::vector<Vec3>& p, int a, int b, int c, double least) {
  const double longest = std::max({(p[b] - p[a]).norm(), (p[c] - p[b]).norm(), (p[a] - p[c]).norm()});
  return twice_area(p, a, b, c).norm() > least * longest;
}

// Panels as they are taken over, one after another.
class PanelTaker {
 public:
  PanelTaker(QuadMesh& mesh, double least_height, MeshRepairs& repairs)
      : mesh_(mesh), least_(least_height), repairs_(repairs) {}

  void take(const std::vector<int>& c, Patch patch) {
    patch_ = patch;
    if (c.size() == 3) return take_triangle(c[0], c[1], c[2]);
    const Quad q = {c[0], c[1], c[2], c[3]};
    const bool first = along02(q);
    if (wrong(q, first) ? !wrong(q, !first) : tied(q))
      return take_halves(q, wrong(q, first) ? !first : lower_diagonal(q));
    if (wrong(q, first)) return take_halves(q, first);
    mesh_.quads.push_back(q);
    mesh_.patch.push_back(patch_);
  }

 private:
  // As contact detection splits it: along the shorter diagonal.
  bool along02(const Quad& q) const {
    return (at(q[0]) - at(q[2])).squaredNorm() <= (at(q[1]) - at(q[3])).squaredNorm();
  }
  const Vec3& at(int k) const { return mesh_.points[k]; }

  // Folded, or with a half without area.
  bool wrong(const Quad& q, bool along_02) const {
    const int k = along_02 ? 0 : 1;
    const int a = q[k], b = q[k + 1], c = q[k + 2], d = q[(k + 3) % 4];
    return twice_area(mesh_.points, a, b, c).dot(twice_area(mesh_.points, a, c, d)) < 0.0 ||
           !has_height(mesh_.points, a, b, c, least_) || !has_height(mesh_.points, a, c, d, least_);
  }

  // Warped, with two diagonals of one length: rounding, or the order of its corners, would choose between two
  // shapes, and not alike on port and starboard.
  bool tied(const Quad& q) const {
    const Vec3 e = at(q[0]) - at(q[2]), f = at(q[1]) - at(q[3]);
    const double length = e.norm();
    if (std::abs(length - f.norm()) > 1e-9 * length) return false;
    const Vec3 normal = e.cross(f);
    return std::abs(normal.dot(at(q[0]) - at(q[1]))) > 1e-6 * length * normal.norm();
  }
  // The one from the lowest corner, of those the foremost, then the one nearest to the centre plane: the same
  // on both sides.
  bool lower_diagonal(const Quad& q) const {
    const auto before = [&](int k, int l) {
      const Vec3 &a = at(q[k]), &b = at(q[l]);
      if (std::abs(a.z() - b.z()) > least_) return a.z() < b.z();
      if (std::abs(a.x() - b.x()) > least_) return a.x() > b.x();
      return std::abs(a.y()) < std::abs(b.y());
    };
    int lowest = 0;
    for (int k = 1; k < 4; ++k)
      if (before(k, lowest)) lowest = k;
    return lowest % 2 == 0;
  }

  void take_halves(const Quad& q, bool along_02) {
    const int k = along_02 ? 0 : 1;
    take_triangle(q[k], q[k + 1], q[k + 2]);
    take_triangle(q[k], q[k + 2], q[(k + 3) % 4]);
    ++repairs_.split;
  }
  void take_triangle(int a, int b, int c) {
    if (!has_height(mesh_.points, a, b, c, least_)) {
      ++repairs_.collapsed;
      return;
    }
    mesh_.quads.push_back({a, b, c, c});
    mesh_.patch.push_back(patch_);
  }

  QuadMesh& mesh_;
  double least_;
  MeshRepairs& repairs_;
  Patch patch_ = Patch::other;
};

// Panels by their corners, lowest number first: what stands twice is found.
struct Corners {
  Quad sorted;
  int panel;
};

// 1 for a panel to keep. Of panels with the same corners one stays; where each of its edges has two more
// panels, it is a wall between two bodies, and none does.
std::vector<char> kept_panels(const std::vector<std::vector<int>>& panels, MeshRepairs& repairs) {
  std::vector<Corners> all;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    Quad s = {panels[k][0], panels[k][1], panels[k][2], panels[k].size() == 4 ? panels[k][3] : -1};
    std::sort(s.begin(), s.end());
    all.push_back({s, static_cast<int>(k)});
  }
  std::sort(all.begin(), all.end(), [](const Corners& a, const Corners& b) {
    return std::tie(a.sorted, a.panel) < std::tie(b.sorted, b.panel);
  });
  std::vector<char> kept(panels.size(), 1);
  std::vector<std::vector<int>> doubled;
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    for (to = from + 1; to < all.size() && all[to].sorted == all[from].sorted;) ++to;
    if (to - from < 2) continue;
    doubled.emplace_back();
    for (std::size_t k = from; k < to; ++k) doubled.back().push_back(all[k].panel);
  }
  if (doubled.empty()) return kept;
  QuadMesh others;
  std::set<int> in_doubled;
  for (const auto& group : doubled) in_doubled.insert(group.begin(), group.end());
  for (std::size_t k = 0; k < panels.size(); ++k)
    if (!in_doubled.count(static_cast<int>(k)))
      others.quads.push_back({panels[k][0], panels[k][1], panels[k][2], panels[k].back()});
  std::map<std::pair<int, int>, int> uses;
  for (const EdgeUse& use : edge_uses(others)) ++uses[{use.lower, use.upper}];
  for (const auto& group : doubled) {
    const std::vector<int>& c = panels[group[0]];
    bool wall = true;
    for (std::size_t k = 0; k < c.size(); ++k)
      wall = wall && uses[std::minmax(c[k], c[(k + 1) % c.size()])] == 2;
    for (std::size_t k = wall ? 0 : 1; k < group.size(); ++k) kept[group[k]] = 0;
    (wall ? repairs.walls : repairs.repeated) += static_cast<int>(group.size()) - (wall ? 0 : 1);
  }
  return kept;
}

QuadMesh joined(const QuadMesh& mesh, MeshRepairs& repairs) {
  const double distance = joining_distance(mesh);
  Joiner joiner(distance);
  std::vector<int> number;
  number.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) number.push_back(joiner.number(p));
  repairs.joined += static_cast<int>(mesh.points.size() - joiner.kept.size());
  std::vector<std::vector<int>> panels;
  std::vector<Patch> patch;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    Quad q = mesh.quads[k];
    for (int& corner : q) corner = number[corner];
    std::vector<int> corners = distinct(q);
    if (corners.size() < 3) {
      ++repairs.collapsed;
      continue;
    }
    panels.push_back(std::move(corners));
    patch.push_back(mesh.patch[k]);
  }
  const std::vector<char> kept = kept_panels(panels, repairs);
  QuadMesh result;
  result.points = std::move(joiner.kept);
  PanelTaker taker(result, distance, repairs);
  for (std::size_t k = 0; k < panels.size(); ++k)
    if (kept[k]) taker.take(panels[k], patch[k]);
  return result;
}

// A quad whose diagonal is an edge of others, or the diagonal of another quad, is split along the other one:
// two quads that share two edges would otherwise share the diagonal.
void split_doublets(QuadMesh& mesh, MeshRepairs& repairs) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> diagonals;
  std::vector<char> shares(mesh.quads.size(), 0);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    if (!mesh.is_triangle(k)) diagonals[contact_diagonal(mesh, k)].push_back(k);
  if (diagonals.empty()) return;
  for (const EdgeUse& use : edge_uses(mesh))
    if (const auto found = diagonals.find({use.lower, use.upper}); found != diagonals.end())
      for (const std::size_t k : found->second) shares[k] = 1;
  for (const auto& [ends, panels] : diagonals)
    for (std::size_t k = 1; k < panels.size(); ++k) shares[panels[k]] = 1;
  if (std::find(shares.begin(), shares.end(), 1) == shares.end()) return;
  QuadMesh result = with_panels(mesh, [&](std::size_t k) { return !shares[k]; });
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    if (!shares[k]) continue;
    const Quad& q = mesh.quads[k];
    const int at = contact_diagonal(mesh, k) == std::pair<int, int>(std::minmax(q[0], q[2])) ? 1 : 0;
    result.quads.push_back({q[at], q[at + 1], q[at + 2], q[at + 2]});
    result.quads.push_back({q[at], q[at + 2], q[(at + 3) % 4], q[(at + 3) % 4]});
    result.patch.insert(result.patch.end(), 2, mesh.patch[k]);
    ++repairs.split;
  }
  mesh = std::move(result);
}

// All open edges on one flat side of the mesh: half a hull, which must not get a lid there.
bool is_half(const QuadMesh& mesh) {
  const Box box = bounding_box(mesh);
  const double width = box.upper.y() - box.lower.y();
  const std::vector<OpenLoop> loops = open_loops(mesh);
  // On either side, or on both sides of the centre plane, where a half and its image do not meet.
  for (const auto& [y, near] :
       {std::make_pair(box.lower.y(), off_centre * width), std::make_pair(box.upper.y(), off_centre * width),
        std::make_pair(0.0, 0.02 * width)})
    for (const OpenLoop& loop : loops) {
      const double plane = y, within = near;
      const auto on_side = std::count_if(loop.ring.begin(), loop.ring.end(), [&](int k) {
        return std::abs(mesh.points[k].y() - plane) <= within;
      });
      // A deck that is missing too leaves a part of the line elsewhere.
      if (loop.across > 0.5 * (box.upper.x() - box.lower.x()) &&
          2 * on_side > static_cast<long>(loop.ring.size()))
        return true;
    }
  return false;
}

// First points that have a partner are joined with it, then those left over are put into edges wherever they
// lie on one.
void close_seams(QuadMesh& mesh, double distance, MeshRepairs& repairs) {
  const double widest = widest_gap * distance / 1e-6;
  SeamRepairs seams;
  for (const double joinable : {widest, 0.0}) {
    if (count_edges(mesh).open > 0)
      for (const int k : insert_corners(mesh, distance, joinable)) {
        ++seams.inserted;
        seams.on_edges.push_back(mesh.points[static_cast<std::size_t>(k)]);
      }
    if (count_edges(mesh).open > 0) close_gaps(mesh, 3.0 * distance, widest, joinable, seams);
  }
  repairs.inserted += seams.inserted;
  repairs.on_edges.insert(repairs.on_edges.end(), seams.on_edges.begin(), seams.on_edges.end());
  repairs.gaps += seams.joined;
  repairs.gap = std::max(repairs.gap, seams.gap);
}

}  // namespace

double joining_distance(const QuadMesh& mesh) {
  const Box box = bounding_box(mesh);
  return 1e-6 * (box.upper - box.lower).maxCoeff();
}

namespace {

// Points of open edges that are meant to lie in y = 0, and the panels of a lid there.
struct CentrePlane {
  std::vector<char> on;  // per point
  int moved = 0;
  double farthest = 0.0;  //!< [m]
};
CentrePlane centre_plane(const QuadMesh& half, double near, double exact) {
  CentrePlane plane;
  plane.on.assign(half.points.size(), 0);
  for_each_edge(edge_uses(half), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) plane.on[first->lower] = plane.on[first->upper] = 1;
  });
  for (std::size_t k = 0; k < half.quads.size(); ++k) {  // a lid has no open edges
    const auto& q = half.quads[k];
    const Vec3 normal = (half.points[q[2]] - half.points[q[0]]).cross(half.points[q[3]] - half.points[q[1]]);
    if (std::abs(normal.y()) > 0.999 * normal.norm())
      for (const int corner : q) plane.on[corner] = 1;
  }
  for (std::size_t k = 0; k < half.points.size(); ++k) {
    const double off = std::abs(half.points[k].y());
    if (off <= exact) plane.on[k] = 1;
    if (off > near) plane.on[k] = 0;
    if (!plane.on[k] || off <= exact) continue;
    ++plane.moved;
    plane.farthest = std::max(plane.farthest, off);
  }
  return plane;
}

void require_one_side(const Box& box, double near, const std::string& path) {
  if (box.lower.y() >= -near || box.upper.y() <= near) return;
  throw InputError(
      text("%s: reaches from y = %g to %g m across the file's centre plane, so it has both sides already: "
           "drop \"mirror\", or export one side",
           path.c_str(), box.lower.y(), box.upper.y()));
}

}  // namespace

QuadMesh with_mirror_image(const QuadMesh& mesh, const std::string& path, MeshRepairs& repairs) {
  const QuadMesh half = without_unused_points(joined(mesh, repairs));
  const double distance = joining_distance(half);
  const Box box = bounding_box(half);
  const double near = off_centre * std::max(box.upper.y(), -box.lower.y());
  require_one_side(box, near, path);
  const CentrePlane plane = centre_plane(half, near, distance);
  repairs.moved_to_centre = plane.moved;
  repairs.off_centre = plane.farthest;
  QuadMesh result;
  result.points = half.points;
  const int n = static_cast<int>(result.points.size());
  for (int k = 0; k < n; ++k)
    if (plane.on[k]) result.points[k].y() = 0.0;
  for (int k = 0; k < n; ++k)
    result.points.push_back(result.points[k].cwiseProduct(Vec3(1.0, -1.0, 1.0)).eval());
  for (std::size_t k = 0; k < half.quads.size(); ++k) {
    const Quad& q = half.quads[k];
    if (std::all_of(q.begin(), q.end(), [&](int corner) { return plane.on[corner]; })) continue;
    result.quads.push_back(q);
    // The image begins with the same corner, so its diagonals are the images of the panel's.
    result.quads.push_back(half.is_triangle(k) ? Quad{q[0] + n, q[2] + n, q[1] + n, q[1] + n}
                                               : Quad{q[0] + n, q[3] + n, q[2] + n, q[1] + n});
    result.patch.insert(result.patch.end(), 2, half.patch[k]);
    ++repairs.mirrored;
  }
  return result;
}

namespace {

// A lid may fall on a panel that hung loose beside its hole: what is there twice goes, and may leave a hole.
void close_holes(QuadMesh& mesh, MeshRepairs& repairs) {
  for (int round = 0; round < 3 && count_edges(mesh).open > 0 && !is_half(mesh); ++round) {
    const HoleRepairs holes = fill_holes(mesh);
    repairs.notes.insert(repairs.notes.end(), holes.words.begin(), holes.words.end());
    if (count_edges(mesh).branching > 0) mesh = joined(mesh, repairs);
    if (!holes.filled) break;
  }
}

// Panels that share one edge with the rest and have the others free, as walls do that end at the rim of a
// hole: where the holes close without them they are left out.
void close_without_flaps(QuadMesh& mesh, MeshRepairs& repairs) {
  std::vector<int> shared(mesh.quads.size(), 0);
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    for (const EdgeUse* use = first; last - first > 1 && use < last; ++use) ++shared[use->panel];
  });
  QuadMesh rest = with_panels(mesh, [&](std::size_t k) { return shared[k] > 1; });
  const auto left = mesh.quads.size() - rest.quads.size();
  if (left == 0 || left > std::max<std::size_t>(1, mesh.quads.size() / 20)) return;
  MeshRepairs then = repairs;
  then.notes.push_back(text("%zu %s that hung free at the rim of a hole %s left out", left,
                            left == 1 ? "panel" : "panels", left == 1 ? "was" : "were"));
  close_holes(rest, then);
  if (count_edges(rest).open > 0) return;
  mesh = std::move(rest);
  repairs = std::move(then);
}

}  // namespace

QuadMesh repaired(const QuadMesh& mesh, const std::string& path, MeshRepairs& repairs) {
  QuadMesh result = without_unused_points(joined(mesh, repairs));
  if (result.quads.empty()) throw InputError(path + ": has no panel with an area");
  split_doublets(result, repairs);
  const double distance = joining_distance(result);
  if (count_edges(result).open > 0) close_seams(result, distance, repairs);
  if (count_edges(result).branching > 0) remove_inner_panels(result, repairs);
  close_holes(result, repairs);
  if (count_edges(result).open > 0 && !is_half(result)) close_without_flaps(result, repairs);
  result = without_unused_points(result);
  repairs.components = turn_outward(result, path, repairs.turned);
  return result;
}

}  // namespace icebow
