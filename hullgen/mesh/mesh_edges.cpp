#include "hullgen/mesh/mesh_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/text.h"
#include "geometry/union_find.h"

namespace icebow {
namespace {

// How often a flaw is there, and where first.
struct Flaw {
  const char* what;
  int places = 0;
  Vec3 first = Vec3::Zero();

  void found(const Vec3& place) {
    if (places++ == 0) first = place;
  }
  std::string words() const {
    return text("%s: %d, one at (%g, %g, %g) m", what, places, first.x(), first.y(), first.z());
  }
};

Flaw repeated_corners(const QuadMesh& mesh) {
  Flaw flaw{"panels with a corner twice"};
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    auto q = mesh.quads[k];
    const auto end = q.begin() + (mesh.is_triangle(k) ? 3 : 4);
    std::sort(q.begin(), end);
    const auto twice = std::adjacent_find(q.begin(), end);
    if (twice != end) flaw.found(mesh.points[*twice]);
  }
  return flaw;
}

// The panels around a point of a manifold surface are joined edge to edge: one fan, and not two or more.
Flaw touching_points(const QuadMesh& mesh, const std::vector<EdgeUse>& uses) {
  UnionFind fans(4 * mesh.quads.size());  // of each panel's four corners
  const auto corner = [&](int panel, int point) {
    const auto& q = mesh.quads[panel];
    return 4 * panel + static_cast<int>(std::find(q.begin(), q.end(), point) - q.begin());
  };
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    for (const EdgeUse* use = first + 1; use < last; ++use)
      for (const int point : {use->lower, use->upper})
        fans.join(corner(first->panel, point), corner(use->panel, point));
  });
  Flaw flaw{"points in which surfaces touch"};
  std::vector<int> fan(mesh.points.size(), -1);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    for (const int point : mesh.quads[k]) {
      const int own = fans.find(corner(static_cast<int>(k), point));
      if (fan[point] >= 0 && fan[point] != own) flaw.found(mesh.points[point]);
      fan[point] = own;
    }
  return flaw;
}

}  // namespace

std::string flaw_of_surface(const QuadMesh& mesh) {
  const Flaw repeated = repeated_corners(mesh);
  if (repeated.places > 0) return repeated.words();
  Flaw branching{"edges of three panels or more"}, turned{"neighbouring panels that face opposite ways"};
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    const Vec3 middle = 0.5 * (mesh.points[first->lower] + mesh.points[first->upper]);
    if (last - first > 2) branching.found(middle);
    if (last - first == 2 && first[0].forward == first[1].forward) turned.found(middle);
  });
  if (branching.places > 0) return branching.words();
  if (turned.places > 0) return turned.words();
  const Flaw touching = touching_points(mesh, uses);
  return touching.places > 0 ? touching.words() : "";
}

std::vector<EdgeUse> edge_uses(const QuadMesh& mesh) {
  // By their lower point first, counted: a point has a handful of edges, and those are sorted among
  // themselves.
  int last = -1;
  for (const auto& q : mesh.quads) last = std::max(last, *std::max_element(q.begin(), q.end()));
  std::vector<std::size_t> first(static_cast<std::size_t>(last + 2), 0);
  const auto each = [&](auto visit) {
    for (std::size_t p = 0; p < mesh.quads.size(); ++p)
      for (int k = 0; k < 4; ++k) {
        const int a = mesh.quads[p][k], b = mesh.quads[p][(k + 1) % 4];
        if (a != b) visit(EdgeUse{std::min(a, b), std::max(a, b), static_cast<int>(p), a < b});
      }
  };
  each([&](const EdgeUse& use) { ++first[static_cast<std::size_t>(use.lower) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeUse> uses(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  each([&](const EdgeUse& use) { uses[next[static_cast<std::size_t>(use.lower)]++] = use; });
  for (std::size_t k = 0; k + 1 < first.size(); ++k)
    std::sort(uses.begin() + static_cast<std::ptrdiff_t>(first[k]),
              uses.begin() + static_cast<std::ptrdiff_t>(first[k + 1]),
              [](const EdgeUse& a, const EdgeUse& b) {
                return std::tie(a.upper, a.panel) < std::tie(b.upper, b.panel);
              });
  return uses;
}

EdgeCount count_edges(const QuadMesh& mesh) {
  EdgeCount count;
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) ++count.open;
    if (last - first > 2) ++count.branching;
  });
  return count;
}

std::vector<int> surface_of_panel(const QuadMesh& mesh, int& surfaces) {
  UnionFind sets(mesh.quads.size());
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    for (const EdgeUse* use = first + 1; use < last; ++use) sets.join(first->panel, use->panel);
  });
  std::vector<int> number(mesh.quads.size(), -1), result(mesh.quads.size());
  surfaces = 0;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    int& own = number[sets.find(static_cast<int>(k))];
    if (own < 0) own = surfaces++;
    result[k] = own;
  }
  return result;
}

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

double panel_area(const QuadMesh& mesh, std::size_t panel) {
  const auto& q = mesh.quads[panel];
  const auto& p = mesh.points;
  return 0.5 * (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).norm();
}

}  // namespace icebow
