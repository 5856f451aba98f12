#include "hullgen/mesh/mesh_holes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/text.h"
#include "hullgen/mesh/mesh_edges.h"
#include "hullgen/mesh/ring_triangles.h"

namespace icebow {
namespace {

constexpr double small_hole = 0.02;   // of the mesh's length, across
constexpr double flat = 2e-3;         // of a hole's width: how far from its plane corners may lie
constexpr double loose_share = 0.05;  // of the largest surface's area

std::string place(const Vec3& p) {
  return text("(%.3g, %.3g, %.3g) m", p.x(), p.y(), p.z());
}

OpenLoop loop_of(const QuadMesh& mesh, std::vector<int> ring) {
  OpenLoop loop;
  loop.ring = std::move(ring);
  Vec3 lower = mesh.points[loop.ring[0]], upper = lower;
  for (const int k : loop.ring) {
    const Vec3& p = mesh.points[k];
    loop.centre += p / static_cast<double>(loop.ring.size());
    lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  }
  loop.across = (upper - lower).norm();
  loop.lowest = lower.z();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const int k : loop.ring) {
    const Vec3 d = mesh.points[k] - loop.centre;
    scatter += d * d.transpose();
  }
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  for (const int k : loop.ring)
    loop.off_plane = std::max(loop.off_plane, std::abs(normal.dot(mesh.points[k] - loop.centre)));
  return loop;
}

void leave_out_loose_pieces(QuadMesh& mesh, HoleRepairs& repairs) {
  int surfaces = 0;
  const std::vector<int> surface = surface_of_panel(mesh, surfaces);
  if (surfaces < 2) return;
  std::vector<double> area(surfaces, 0.0);
  std::vector<char> open(surfaces, 0);
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) area[surface[k]] += panel_area(mesh, k);
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first == 1) open[surface[first->panel]] = 1;
  });
  const double least = loose_share * *std::max_element(area.begin(), area.end());
  const auto loose = [&](int s) { return open[s] && area[s] < least; };
  int pieces = 0, panels = 0;
  double total = 0.0;
  Vec3 at = Vec3::Zero();
  for (int s = 0; s < surfaces; ++s)
    if (loose(s)) ++pieces, total += area[s];
  if (pieces == 0) return;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    if (loose(surface[k]) && panels++ == 0) at = mesh.points[mesh.quads[k][0]];
  mesh = with_panels(mesh, [&](std::size_t k) { return !loose(surface[k]); });
  repairs.words.push_back(text("%d loose %s of %d panels, %.3g m2, that %s nothing %s left out, one at ",
                               pieces, pieces == 1 ? "piece" : "pieces", panels, total,
                               pieces == 1 ? "encloses" : "enclose", pieces == 1 ? "was" : "were") +
                          place(at));
}

const char* why_filled(const OpenLoop& loop, double length) {
  if (loop.across <= small_hole * length) return "small";
  if (loop.off_plane <= flat * loop.across) return "flat";
  if (loop.lowest > 0.0) return "above the waterline";
  return nullptr;
}

}  // namespace

std::vector<OpenLoop> open_loops(const QuadMesh& mesh) {
  std::map<int, std::vector<int>> next;
  for_each_edge(edge_uses(mesh), [&](const EdgeUse* first, const EdgeUse* last) {
    if (last - first != 1) return;
    next[first->lower].push_back(first->upper);
    next[first->upper].push_back(first->lower);
  });
  const auto take = [&](int from, int to) {
    for (const auto& [a, b] : {std::make_pair(from, to), std::make_pair(to, from)}) {
      std::vector<int>& list = next[a];
      list.erase(std::find(list.begin(), list.end(), b));
    }
  };
  std::vector<OpenLoop> loops;
  for (const auto& entry : next) {
    while (!entry.second.empty()) {
      // Where the walk comes back to a point it has been at, the way since then is a loop of its own.
      std::vector<int> way = {entry.first};
      while (!next[way.back()].empty()) {
        const int to = next[way.back()].back();
        take(way.back(), to);
        const auto been = std::find(way.begin(), way.end(), to);
        if (been == way.end()) {
          way.push_back(to);
          continue;
        }
        if (way.end() - been > 2) loops.push_back(loop_of(mesh, {been, way.end()}));
        way.erase(been + 1, way.end());
      }
    }
  }
  return loops;
}

HoleRepairs fill_holes(QuadMesh& mesh) {
  HoleRepairs repairs;
  leave_out_loose_pieces(mesh, repairs);
  const Box box = bounding_box(mesh);
  const double length = (box.upper - box.lower).maxCoeff();
  std::map<std::string, std::pair<int, OpenLoop>> filled;  // by why: how many, and the widest
  for (const OpenLoop& loop : open_loops(mesh)) {
    const char* why = why_filled(loop, length);
    if (why == nullptr) continue;
    const auto lid = ring_triangles(mesh.points, loop.ring);
    if (lid.empty()) continue;
    for (const auto& t : lid) {
      mesh.quads.push_back({t[0], t[1], t[2], t[2]});
      mesh.patch.push_back(Patch::other);
    }
    auto& [count, widest] = filled[why];
    if (count++ == 0 || loop.across > widest.across) widest = loop;
  }
  for (const auto& [why, holes] : filled)
    repairs.words.push_back((holes.first == 1 ? text("1 hole (%s) was filled", why.c_str())
                                              : text("%d holes (%s) were filled", holes.first, why.c_str())) +
                            text(", the widest %.3g m across, at ", holes.second.across) +
                            place(holes.second.centre));
  repairs.filled = !filled.empty();
  return repairs;
}

}  // namespace icebow
