#include "hullgen/mesh/panel_orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/text.h"
#include "hullgen/mesh/mesh_edges.h"
#include "hullgen/mesh/mesh_holes.h"

namespace icebow {
namespace {

Vec3 middle(const QuadMesh& mesh, const EdgeUse& edge) {
  return 0.5 * (mesh.points[edge.lower] + mesh.points[edge.upper]);
}

std::string place(const Vec3& p) {
  return text("(%g, %g, %g) m", p.x(), p.y(), p.z());
}

// Half a hull: most of its open edges lie along the ship, near one flat side of it. How far off the plane y =
// 0 of the file they lie is for the message.
std::string advice(const QuadMesh& mesh, const std::vector<EdgeUse>& open) {
  const Box box = bounding_box(mesh);
  const double width = box.upper.y() - box.lower.y();
  const auto farthest_from = [&](double y) {
    double farthest = 0.0;
    for (const EdgeUse& edge : open)
      for (const int k : {edge.lower, edge.upper})
        farthest = std::max(farthest, std::abs(mesh.points[k].y() - y));
    return farthest;
  };
  for (const double y : {box.lower.y(), box.upper.y()})
    if (farthest_from(y) <= 0.02 * width)
      return "all lie in one plane along the ship; if this is one side of a hull, ask for its mirror image "
             "(\"mirror\": true in a study, --mirror of icebow measure)";
  if (farthest_from(0.0) <= 0.02 * width)
    return text(
        "all lie within %.3g m of the centre plane: the two sides do not meet there; let the rim of the half "
        "lie in "
        "the plane",
        farthest_from(0.0));
  return "close deck and transom, and let panels meet corner to corner";
}

void refuse_open(const QuadMesh& mesh, const std::vector<EdgeUse>& open, const std::string& path) {
  if (open.empty()) return;
  const std::vector<OpenLoop> loops = open_loops(mesh);
  std::string widest;
  if (!loops.empty()) {
    const OpenLoop& loop = *std::max_element(
        loops.begin(), loops.end(), [](const OpenLoop& a, const OpenLoop& b) { return a.across < b.across; });
    widest = text(" in %zu %s, the widest %.3g m across", loops.size(), loops.size() == 1 ? "hole" : "holes",
                  loop.across);
  }
  throw InputError(text(
      "%s: the mesh is not closed: %zu open edges%s, one at %s in the frame of the hull: %s", path.c_str(),
      open.size(), widest.c_str(), place(middle(mesh, open.front())).c_str(), advice(mesh, open).c_str()));
}

void refuse_branches(const QuadMesh& mesh, const std::vector<EdgeUse>& uses, const std::string& path) {
  int branches = 0;
  std::string first_one;
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first < 3 || branches++ > 0) return;
    first_one = text("one joins %td at %s in the frame of the hull", last - first,
                     place(middle(mesh, *first)).c_str());
  });
  if (branches > 0)
    throw InputError(text(
        "%s: the mesh is not the surface of a body: %d edges join more than two panels, %s: remove inner "
        "walls, and surfaces that touch along an edge",
        path.c_str(), branches, first_one.c_str()));
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
  Walk(QuadMesh& mesh, const std::vector<EdgeUse>& uses, const std::string& path)
      : mesh_(mesh),
        path_(path),
        neighbours_(mesh.quads.size()),
        state_(mesh.quads.size(), unseen),
        empty_(mesh.quads.size(), 0) {
    for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse*) {
      const bool agree = first[0].forward != first[1].forward;
      neighbours_[first[0].panel].push_back({first[1].panel, agree});
      neighbours_[first[1].panel].push_back({first[0].panel, agree});
    });
  }

  int turn(int& turned) {
    int surfaces = 0;
    for (std::size_t p = 0; p < state_.size(); ++p) {
      if (state_[p] != unseen) continue;
      if (turn_surface(static_cast<int>(p), turned)) ++surfaces;
    }
    return surfaces;
  }
  // Panels of closed surfaces that enclose nothing, like two triangles back to back.
  const std::vector<char>& empty() const { return empty_; }

 private:
  enum State : char { unseen, kept, turned_over };
  struct Neighbour {
    int panel;
    bool agrees;
  };

  bool turn_surface(int first, int& turned) {
    const std::vector<int> surface = collect(first);
    double volume = 0.0, area = 0.0;
    for (const int p : surface) {
      volume += (state_[p] == kept ? 1.0 : -1.0) * six_volumes(mesh_, p) / 6.0;
      area += panel_area(mesh_, static_cast<std::size_t>(p));
    }
    // A tetrahedron of that area has 0.1 of area^1.5; what has a billionth of it is flat, and rounding says
    // the sign.
    if (std::abs(volume) <= 1e-9 * std::pow(area, 1.5)) {
      for (const int p : surface) empty_[p] = 1;
      return false;
    }
    const State wrong = volume < 0.0 ? kept : turned_over;
    for (const int p : surface)
      if (state_[p] == wrong) turn_over(mesh_, p), ++turned;
    return true;
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
  std::vector<char> empty_;
};

}  // namespace

int turn_outward(QuadMesh& mesh, const std::string& path, int& turned) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  refuse_branches(mesh, uses, path);
  std::vector<EdgeUse> open;
  for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) open.push_back(*first);
  });
  refuse_open(mesh, open, path);
  Walk walk(mesh, uses, path);
  const int surfaces = walk.turn(turned);
  if (surfaces == 0) {
    const Vec3& at = mesh.points[mesh.quads[0][0]];
    throw InputError(text("%s: the closed surface through (%g, %g, %g) m encloses nothing", path.c_str(),
                          at.x(), at.y(), at.z()));
  }
  mesh = without_unused_points(with_panels(mesh, [&](std::size_t k) { return !walk.empty()[k]; }));
  return surfaces;
}

}  // namespace icebow
