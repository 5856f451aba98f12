#include "hullgen/mesh/mesh_seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "hullgen/mesh/mesh_edges.h"
#include "hullgen/mesh/ring_triangles.h"

namespace icebow {
namespace {

struct OpenEdge {
  int a, b, panel;
};

std::vector<OpenEdge> open_edges(const QuadMesh& mesh) {
  std::vector<OpenEdge> open;
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) open.push_back({first->lower, first->upper, first->panel});
  });
  return open;
}

std::vector<int> ends_of(const std::vector<OpenEdge>& open) {
  std::set<int> ends;
  for (const OpenEdge& e : open) ends.insert({e.a, e.b});
  return {ends.begin(), ends.end()};
}

// Points by their x, so that those near an edge are found without looking at all.
class ByX {
 public:
  ByX(const std::vector<Vec3>& points, const std::vector<int>& of) {
    for (const int k : of) sorted_.push_back({points[k].x(), k});
    std::sort(sorted_.begin(), sorted_.end());
  }
  template <class Visit>
  void between(double lower, double upper, Visit visit) const {
    auto p = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(lower, -1));
    for (; p != sorted_.end() && p->first <= upper; ++p) visit(p->second);
  }

 private:
  std::vector<std::pair<double, int>> sorted_;
};

// How far a point of an open edge may move: a third of the shortest edge of its panels.
using Reach = std::unordered_map<int, double>;
Reach reaches(const QuadMesh& mesh, const std::vector<int>& ends) {
  Reach reach;
  for (const int k : ends) reach[k] = 1e300;
  for (const auto& q : mesh.quads)
    for (int k = 0; k < 4; ++k) {
      const int a = q[k], b = q[(k + 1) % 4];
      if (a == b) continue;
      for (const int end : {a, b})
        if (const auto found = reach.find(end); found != reach.end())
          found->second = std::min(found->second, (mesh.points[a] - mesh.points[b]).norm() / 3.0);
    }
  return reach;
}

struct Inserted {
  double share;  // of the way from a to b
  int point;
};
using Insertions = std::map<std::pair<int, int>, std::vector<Inserted>>;  // by edge, lower point first

// A point that may be joined with an end of the edge across a gap of `joinable` is left for that: put into
// the edge beside its end it would make a sliver.
Insertions points_on_edges(const QuadMesh& mesh, const std::vector<OpenEdge>& open, double distance,
                           double joinable) {
  const std::vector<int> all = ends_of(open);
  const ByX ends(mesh.points, all);
  const Reach reach = joinable > 0.0 ? reaches(mesh, all) : Reach();
  const auto belongs_to = [&](int k, int end) {
    return joinable > 0.0 &&
           (mesh.points[k] - mesh.points[end]).norm() <= std::min({joinable, reach.at(k), reach.at(end)});
  };
  Insertions result;
  for (const OpenEdge& e : open) {
    const Vec3 &a = mesh.points[e.a], &b = mesh.points[e.b];
    const double length = (b - a).norm();
    if (!(length > 2.0 * distance)) continue;
    std::vector<Inserted> on;
    ends.between(std::min(a.x(), b.x()) - distance, std::max(a.x(), b.x()) + distance, [&](int k) {
      const auto& own = mesh.quads[e.panel];
      if (std::find(own.begin(), own.end(), k) != own.end()) return;
      const double share = (mesh.points[k] - a).dot(b - a) / (length * length);
      if (share * length <= distance || (1.0 - share) * length <= distance) return;
      if ((a + share * (b - a) - mesh.points[k]).norm() > distance) return;
      if (!belongs_to(k, e.a) && !belongs_to(k, e.b)) on.push_back({share, k});
    });
    if (on.empty()) continue;
    std::sort(on.begin(), on.end(), [](const Inserted& p, const Inserted& q) { return p.share < q.share; });
    result[{e.a, e.b}] = on;
  }
  return result;
}

// The corners of a triangle with the points that were put into its edges.
std::vector<int> ring_with(const std::array<int, 3>& t, const Insertions& inserted) {
  std::vector<int> ring;
  for (int k = 0; k < 3; ++k) {
    const int a = t[k], b = t[(k + 1) % 3];
    ring.push_back(a);
    const auto found = inserted.find(std::minmax(a, b));
    if (found == inserted.end()) continue;
    std::vector<Inserted> on = found->second;
    if (a > b) std::reverse(on.begin(), on.end());
    for (const Inserted& i : on) ring.push_back(i.point);
  }
  return ring;
}

std::vector<std::array<int, 3>> halves(const QuadMesh& mesh, std::size_t panel) {
  const auto& q = mesh.quads[panel];
  const auto& p = mesh.points;
  if (mesh.is_triangle(panel)) return {{q[0], q[1], q[2]}};
  if ((p[q[0]] - p[q[2]]).squaredNorm() <= (p[q[1]] - p[q[3]]).squaredNorm())
    return {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}};
  return {{q[1], q[2], q[3]}, {q[1], q[3], q[0]}};
}

// Corners joined as `into` says; panels that collapse are left out.
QuadMesh renumbered(const QuadMesh& mesh, const std::vector<int>& into) {
  QuadMesh result;
  result.points = mesh.points;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    std::vector<int> c;
    for (int corner : mesh.quads[k])
      if (c.empty() || c.back() != into[corner]) c.push_back(into[corner]);
    while (c.size() > 1 && c.front() == c.back()) c.pop_back();
    if (c.size() < 3 || std::set<int>(c.begin(), c.end()).size() < c.size()) continue;
    result.quads.push_back({c[0], c[1], c[2], c.back()});
    result.patch.push_back(mesh.patch[k]);
  }
  return result;
}

struct Pair {
  double distance;
  int a, b;
};

std::vector<Pair> near_pairs(const QuadMesh& mesh, double distance) {
  const std::vector<OpenEdge> open = open_edges(mesh);
  const std::vector<int> ends = ends_of(open);
  const Reach reach = reaches(mesh, ends);
  std::set<std::pair<int, int>> neighbours;
  for (const OpenEdge& e : open) neighbours.insert(std::minmax(e.a, e.b));
  const ByX by_x(mesh.points, ends);
  std::vector<Pair> pairs;
  for (const int a : ends)
    by_x.between(mesh.points[a].x() - distance, mesh.points[a].x() + distance, [&](int b) {
      if (b <= a || neighbours.count({a, b})) return;
      const double d = (mesh.points[a] - mesh.points[b]).norm();
      if (d <= std::min({distance, reach.at(a), reach.at(b)})) pairs.push_back({d, a, b});
    });
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
  });
  return pairs;
}

}  // namespace

std::vector<int> insert_corners(QuadMesh& mesh, double distance, double joinable) {
  const std::vector<OpenEdge> open = open_edges(mesh);
  const Insertions inserted = points_on_edges(mesh, open, distance, joinable);
  if (inserted.empty()) return {};
  std::set<int> touched;
  std::vector<int> put_in;
  for (const OpenEdge& e : open)
    if (const auto found = inserted.find({e.a, e.b}); found != inserted.end()) {
      touched.insert(e.panel);
      for (const Inserted& i : found->second) put_in.push_back(i.point);
    }
  QuadMesh result = with_panels(mesh, [&](std::size_t k) { return touched.count(static_cast<int>(k)) == 0; });
  for (const int panel : touched)
    for (const auto& half : halves(mesh, static_cast<std::size_t>(panel)))
      for (const auto& t : ring_triangles(mesh.points, ring_with(half, inserted))) {
        result.quads.push_back({t[0], t[1], t[2], t[2]});
        result.patch.push_back(mesh.patch[panel]);
      }
  mesh = std::move(result);
  return put_in;
}

namespace {

// Points that were joined into which, with what that made.
struct Joining {
  QuadMesh mesh;
  std::vector<Pair> pairs;
  double gap = 0.0;  //!< the widest of them [m]
};
Joining with_joined(const QuadMesh& mesh, const std::vector<Pair>& pairs,
                    const std::set<std::pair<int, int>>& barred) {
  Joining result;
  std::vector<int> into(mesh.points.size());
  std::iota(into.begin(), into.end(), 0);
  std::set<int> used;
  for (const Pair& p : pairs) {
    if (used.count(p.a) || used.count(p.b) || barred.count({p.a, p.b})) continue;
    into[p.b] = p.a;
    used.insert({p.a, p.b});
    result.gap = std::max(result.gap, p.distance);
    result.pairs.push_back(p);
  }
  result.mesh = result.pairs.empty() ? mesh : renumbered(mesh, into);
  return result;
}

// The joinings whose point is an end of an edge of three panels.
std::set<std::pair<int, int>> branching_pairs(const Joining& joining) {
  std::set<int> ends;
  for_each_edge(edge_uses(joining.mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first > 2) ends.insert({first->lower, first->upper});
  });
  std::set<std::pair<int, int>> found;
  for (const Pair& p : joining.pairs)
    if (ends.count(p.a)) found.insert({p.a, p.b});
  return found;
}

}  // namespace

void close_gaps(QuadMesh& mesh, double narrowest, double widest, double joinable, SeamRepairs& repairs) {
  EdgeCount now = count_edges(mesh);
  std::set<std::pair<int, int>> barred;
  for (double distance = narrowest; now.open > 0 && distance <= widest * 1.0001;
       distance *= std::sqrt(10.0)) {
    const std::vector<Pair> pairs = near_pairs(mesh, distance);
    Joining closed = with_joined(mesh, pairs, barred);
    if (count_edges(closed.mesh).branching > now.branching) {
      const auto wrong = branching_pairs(closed);
      barred.insert(wrong.begin(), wrong.end());
      closed = with_joined(mesh, pairs, barred);
    }
    const auto inserted = insert_corners(closed.mesh, distance, joinable).size();
    const EdgeCount then = count_edges(closed.mesh);
    const auto joined = closed.pairs.size();
    if (joined + inserted == 0 || then.open >= now.open || then.branching > now.branching) continue;
    if (pairs.size() > joined + barred.size()) distance /= std::sqrt(10.0);  // some are left at this width
    mesh = std::move(closed.mesh);
    now = then;
    repairs.joined += static_cast<int>(joined);
    repairs.inserted += static_cast<int>(inserted);
    repairs.gap = std::max({repairs.gap, closed.gap, inserted > 0 ? distance : 0.0});
  }
}

}  // namespace icebow
