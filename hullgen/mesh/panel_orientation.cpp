#include "hullgen/mesh/panel_orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "base/text.h"

namespace icebow {
namespace {

struct Side {
  int panel;
  bool forward;  // the panel runs from the lower to the higher point
};
using Edges = std::map<std::pair<int, int>, std::vector<Side>>;

Edges edges_of(const QuadMesh& mesh) {
  Edges edges;
  for (std::size_t p = 0; p < mesh.quads.size(); ++p)
    for (int k = 0; k < 4; ++k) {
      const int a = mesh.quads[p][k], b = mesh.quads[p][(k + 1) % 4];
      if (a != b) edges[std::minmax(a, b)].push_back({static_cast<int>(p), a < b});
    }
  return edges;
}

Vec3 middle(const QuadMesh& mesh, const std::pair<int, int>& edge) {
  return 0.5 * (mesh.points[edge.first] + mesh.points[edge.second]);
}

// All on one flat side of the mesh: half a hull.
bool on_one_side(const QuadMesh& mesh, const std::vector<std::pair<int, int>>& open) {
  const Box box = bounding_box(mesh);
  const double near = 1e-3 * (box.upper.y() - box.lower.y());
  for (const double y : {box.lower.y(), box.upper.y()})
    if (std::all_of(open.begin(), open.end(),
                    [&](const auto& edge) { return std::abs(middle(mesh, edge).y() - y) <= near; }))
      return true;
  return false;
}

void refuse_open(const QuadMesh& mesh, const std::vector<std::pair<int, int>>& open,
                 const std::string& path) {
  if (open.empty()) return;
  const Vec3 at = middle(mesh, open.front());
  throw InputError(text(
      "%s: the mesh is not closed: %zu open edges, one at (%g, %g, %g) m in the frame of the hull: %s",
      path.c_str(), open.size(), at.x(), at.y(), at.z(),
      on_one_side(mesh, open)
          ? "all lie in one plane along the ship; if this is one side of a hull, ask for its mirror image "
            "(\"mirror\": true in a study, --mirror of icebow measure)"
          : "close deck and transom, and let panels meet corner to corner"));
}

void refuse_branches(const QuadMesh& mesh, const Edges& edges, const std::string& path) {
  int branches = 0;
  std::string first;
  for (const auto& [edge, sides] : edges) {
    if (sides.size() < 3 || branches++ > 0) continue;
    const Vec3 at = middle(mesh, edge);
    first = text("one joins %zu at (%g, %g, %g) m in the frame of the hull", sides.size(), at.x(), at.y(),
                 at.z());
  }
  if (branches > 0)
    throw InputError(text(
        "%s: the mesh is not the surface of a body: %d edges join more than two panels, %s: remove inner "
        "walls, and surfaces that touch along an edge",
        path.c_str(), branches, first.c_str()));
}

void turn_over(QuadMesh& mesh, int panel) {
  auto& q = mesh.quads[panel];
  q = mesh.is_triangle(panel) ? std::array<int, 4>{q[0], q[2], q[1], q[1]}
                              : std::array<int, 4>{q[0], q[3], q[2], q[1]};
}

double six_volumes(const QuadMesh& mesh, int panel) {
  const auto& q = mesh.quads[panel];
  const Vec3 &a = mesh.points[q[0]], &b = mesh.points[q[1]], &c = mesh.points[q[2]], &d = mesh.points[q[3]];
  return a.dot(b.cross(c)) + a.dot(c.cross(d));
}

// Walks over the panels of one surface after another.
class Walk {
 public:
  Walk(QuadMesh& mesh, const Edges& edges, const std::string& path)
      : mesh_(mesh), path_(path), neighbours_(mesh.quads.size()), state_(mesh.quads.size(), unseen) {
    for (const auto& [edge, sides] : edges) {
      const bool agree = sides[0].forward != sides[1].forward;
      neighbours_[sides[0].panel].push_back({sides[1].panel, agree});
      neighbours_[sides[1].panel].push_back({sides[0].panel, agree});
    }
  }

  int turn(int& turned) {
    int surfaces = 0;
    for (std::size_t p = 0; p < state_.size(); ++p) {
      if (state_[p] != unseen) continue;
      turned += turn_surface(static_cast<int>(p));
      ++surfaces;
    }
    return surfaces;
  }

 private:
  enum State : char { unseen, kept, turned_over };
  struct Neighbour {
    int panel;
    bool agrees;
  };

  int turn_surface(int first) {
    const std::vector<int> surface = collect(first);
    double volume = 0.0;
    for (const int p : surface) volume += (state_[p] == kept ? 1.0 : -1.0) * six_volumes(mesh_, p) / 6.0;
    const Vec3& at = mesh_.points[mesh_.quads[first][0]];
    if (volume == 0.0)
      throw InputError(text("%s: the closed surface through (%g, %g, %g) m encloses nothing: remove it",
                            path_.c_str(), at.x(), at.y(), at.z()));
    const State wrong = volume < 0.0 ? kept : turned_over;
    int count = 0;
    for (const int p : surface)
      if (state_[p] == wrong) turn_over(mesh_, p), ++count;
    return count;
  }

  std::vector<int> collect(int first) {
    std::vector<int> surface = {first};
    state_[first] = kept;
    for (std::size_t k = 0; k < surface.size(); ++k) {
      const State own = state_[surface[k]];
      for (const Neighbour& n : neighbours_[surface[k]]) {
        const State wanted = (own == kept) == n.agrees ? kept : turned_over;
        if (state_[n.panel] == unseen) {
          state_[n.panel] = wanted;
          surface.push_back(n.panel);
        } else if (state_[n.panel] != wanted) {
          const Vec3& at = mesh_.points[mesh_.quads[n.panel][0]];
          throw InputError(
              text("%s: the surface has one side only, like a Moebius strip, near (%g, %g, %g) m",
                   path_.c_str(), at.x(), at.y(), at.z()));
        }
      }
    }
    return surface;
  }

  QuadMesh& mesh_;
  const std::string& path_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<State> state_;
};

}  // namespace

int turn_outward(QuadMesh& mesh, const std::string& path, int& turned) {
  const Edges edges = edges_of(mesh);
  refuse_branches(mesh, edges, path);
  std::vector<std::pair<int, int>> open;
  for (const auto& [edge, sides] : edges)
    if (sides.size() == 1) open.push_back(edge);
  refuse_open(mesh, open, path);
  return Walk(mesh, edges, path).turn(turned);
}

}  // namespace icebow
