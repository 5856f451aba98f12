#include "hullgen/mesh/mesh_visibility.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/text.h"
#include "geometry/triangles.h"
#include "geometry/union_find.h"
#include "hullgen/mesh/mesh_edges.h"

namespace icebow {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

constexpr double flap_share = 0.05;  // of all panels' area

Point point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Triangles loose_triangles(const QuadMesh& mesh) {
  Triangles result;
  for (const auto& t : triangles(mesh))
    result.emplace_back(point(mesh.points[t[0]]), point(mesh.points[t[1]]), point(mesh.points[t[2]]));
  return result;
}

// Directions all around, evenly enough (Fibonacci's spiral).
std::vector<Vec3> directions(int n) {
  std::vector<Vec3> all;
  for (int k = 0; k < n; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / n, r = std::sqrt(1.0 - z * z), turn = 2.399963229728653 * k;
    all.push_back({r * std::cos(turn), r * std::sin(turn), z});
  }
  return all;
}

// Which sides of a panel see the outside.
class Visibility {
 public:
  explicit Visibility(const QuadMesh& mesh)
      : mesh_(mesh), surface_(loose_triangles(mesh)), tree_(surface_.begin(), surface_.end()) {
    const Box box = bounding_box(mesh);
    lift_ = 1e-7 * (box.upper - box.lower).maxCoeff();
  }

  // With `steepest` only rays that rise less than that are sent.
  bool seen(std::size_t panel, double side, double steepest = 2.0) const {
    const auto& q = mesh_.quads[panel];
    const Vec3 &a = mesh_.points[q[0]], &b = mesh_.points[q[1]], &c = mesh_.points[q[2]];
    const Vec3 normal = side * (b - a).cross(c - a).normalized();
    const Vec3 from = (a + b + c) / 3.0 + lift_ * normal;
    int tried = 0, escaped = 0;
    for (const Vec3& d : rays_) {
      if (d.dot(normal) < 0.1 || d.z() > steepest) continue;
      ++tried;
      if (!tree_.do_intersect(Kernel::Ray_3(point(from), Kernel::Vector_3(d.x(), d.y(), d.z())))) ++escaped;
    }
    return tried > 0 && escaped > 0.1 * tried;  // the odd ray slips through a seam
  }

  bool inside(const Vec3& p) const {
    int votes = 0;
    for (int k = 0; k < 5; ++k) {
      const Vec3 d = rays_[static_cast<std::size_t>(7 * k + 3)];
      votes += tree_.number_of_intersected_primitives(
                   Kernel::Ray_3(point(p), Kernel::Vector_3(d.x(), d.y(), d.z()))) %
                           2 ==
                       1
                   ? 1
                   : -1;
    }
    return votes > 0;
  }

 private:
  const QuadMesh& mesh_;
  Triangles surface_;
  Tree tree_;
  double lift_;
  std::vector<Vec3> rays_ = directions(60);
};

// Pieces of the mesh between its branching edges.
std::vector<int> pieces_between_branches(const QuadMesh& mesh, int& pieces) {
  UnionFind sets(mesh.quads.size());
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 2) sets.join(first[0].panel, first[1].panel);
  });
  std::vector<int> number(mesh.quads.size(), -1), result(mesh.quads.size());
  pieces = 0;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    int& own = number[sets.find(static_cast<int>(k))];
    if (own < 0) own = pieces++;
    result[k] = own;
  }
  return result;
}

// Pieces seen from outside on one side exactly are the hull; some of their panels are asked.
std::vector<char> outer_pieces(const QuadMesh& mesh, const std::vector<int>& piece, int pieces) {
  std::vector<std::vector<std::size_t>> panels(pieces);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) panels[piece[k]].push_back(k);
  const Visibility visibility(mesh);
  std::vector<char> outer(pieces, 0);
  for (int p = 0; p < pieces; ++p) {
    constexpr std::size_t most = 30;
    int hull = 0,
        sheet =
            0;  // panels seen on one side, on both; which side is the outer one differs where some are turned
    const std::size_t step = std::max<std::size_t>(1, panels[p].size() / most);
    for (std::size_t k = (step - 1) / 2; k < panels[p].size(); k += step) {
      const bool front = visibility.seen(panels[p][k], 1.0), back = visibility.seen(panels[p][k], -1.0);
      if (front != back) ++hull;
      if (front && back) ++sheet;
    }
    outer[p] = hull > sheet ? 1 : sheet > 0 ? 2 : 0;
  }
  return outer;
}

// Angle of a panel about an edge.
double angle_about(const QuadMesh& mesh, const EdgeUse& use, const Vec3& along, const Vec3& reference) {
  Vec3 centre = Vec3::Zero();
  for (const int k : mesh.quads[use.panel]) centre += 0.25 * mesh.points[k];
  const Vec3 d = centre - mesh.points[use.lower];
  return std::atan2(along.dot(reference.cross(d)), reference.dot(d - along.dot(d) * along));
}

// Pairs the panels at each edge of four, six ... so that a pair has solid matter between them, and gives each
// body its own points there.
void part_touching_bodies(QuadMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  const Visibility visibility(mesh);
  std::map<int, std::vector<std::pair<int, int>>> pairs_at;  // by point: panels that stay together
  std::set<int> at;
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first > 2) at.insert({first->lower, first->upper});
  });
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    if (!at.count(first->lower) && !at.count(first->upper)) return;
    std::vector<std::pair<int, int>> together;
    const auto n = last - first;
    if (n == 2) together.push_back({first[0].panel, first[1].panel});
    if (n > 2 && n % 2 == 0) {
      const Vec3 a = mesh.points[first->lower], along = (mesh.points[first->upper] - a).normalized();
      const Vec3 reference = along.unitOrthogonal();
      std::vector<std::pair<double, int>> around;
      for (const EdgeUse* u = first; u < last; ++u)
        around.push_back({angle_about(mesh, *u, along, reference), u->panel});
      std::sort(around.begin(), around.end());
      const double between = 0.5 * (around[0].first + around[1].first);
      const double length = (mesh.points[first->upper] - a).norm();
      const Vec3 probe =
          0.5 * (a + mesh.points[first->upper]) +
          1e-3 * length * (std::cos(between) * reference + std::sin(between) * along.cross(reference));
      const std::size_t from = visibility.inside(probe) ? 0 : 1;
      for (std::size_t k = from; k < around.size() + from; k += 2)
        together.push_back({around[k % around.size()].second, around[(k + 1) % around.size()].second});
    }
    for (const int end : {first->lower, first->upper})
      if (at.count(end)) pairs_at[end].insert(pairs_at[end].end(), together.begin(), together.end());
  });
  for (const auto& [corner, pairs] : pairs_at) {
    std::map<int, int> parent;
    const auto root = [&](int k) {
      while (parent[k] != k) k = parent[k];
      return k;
    };
    for (const auto& [p, q] : pairs)
      for (const int k : {p, q}) parent.try_emplace(k, k);
    for (const auto& [p, q] : pairs) parent[root(p)] = root(q);
    std::map<int, int> own;  // by body: its point
    for (const auto& entry : parent) {
      const int body = root(entry.first);
      if (!own.count(body)) {
        own[body] = own.empty() ? corner : static_cast<int>(mesh.points.size());
        if (own[body] != corner) mesh.points.push_back(Vec3(mesh.points[corner]));
      }
      for (int& k : mesh.quads[entry.first])
        if (k == corner) k = own[body];
    }
  }
}

// Pieces that hang on one edge of the hull with a free edge of their own enclose nothing, wherever they are
// seen from.
void leave_out_flaps(QuadMesh& mesh, MeshRepairs& repairs) {
  const EdgeCount before = count_edges(mesh);
  int pieces = 0;
  const std::vector<int> piece = pieces_between_branches(mesh, pieces);
  std::vector<double> area(pieces, 0.0);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) area[piece[k]] += panel_area(mesh, k);
  std::vector<char> free_edge(pieces, 0);
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) free_edge[piece[first->panel]] = 1;
  });
  const double most = flap_share * std::accumulate(area.begin(), area.end(), 0.0);
  const auto flap = [&](std::size_t k) { return free_edge[piece[k]] && area[piece[k]] < most; };
  QuadMesh rest = with_panels(mesh, [&](std::size_t k) { return !flap(k); });
  const EdgeCount then = count_edges(rest);
  if (then.branching >= before.branching || then.open > before.open) return;
  const auto left = mesh.quads.size() - rest.quads.size();
  repairs.notes.push_back(
      left == 1
          ? "1 panel that hangs on an edge of the hull, and encloses nothing, was left out"
          : text("%zu panels that hang on edges of the hull, and enclose nothing, were left out", left));
  mesh = std::move(rest);
}

}  // namespace

void remove_inner_panels(QuadMesh& mesh, MeshRepairs& repairs) {
  leave_out_flaps(mesh, repairs);
  if (count_edges(mesh).branching == 0) return;
  const int before = count_edges(mesh).branching;
  int pieces = 0;
  const std::vector<int> piece = pieces_between_branches(mesh, pieces);
  const std::vector<char> outer = outer_pieces(mesh, piece, pieces);
  QuadMesh shell = with_panels(mesh, [&](std::size_t k) { return outer[piece[k]] == 1; });
  const auto left = mesh.quads.size() - shell.quads.size();
  const EdgeCount then = count_edges(shell);
  if (left > 0 && !shell.quads.empty() && then.branching < before) {
    repairs.notes.push_back(
        text("%zu panels of walls inside the hull, or of sheets that enclose nothing, were left out", left));
    mesh = std::move(shell);
  }
  if (count_edges(mesh).branching == 0) return;
  QuadMesh parted = mesh;
  part_touching_bodies(parted);
  if (count_edges(parted).branching < count_edges(mesh).branching) mesh = std::move(parted);
}

QuadMesh outer_surface(const QuadMesh& mesh) {
  const Visibility visibility(mesh);
  return with_panels(mesh, [&](std::size_t k) { return visibility.seen(k, 1.0, 0.0); });
}

}  // namespace icebow
