// Which panels meet in which edge.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// One panel's side: its edge runs from `lower` to `upper` where `forward`, otherwise back.
struct EdgeUse {
  int lower, upper;  // points
  int panel;
  bool forward;

  bool same_edge(const EdgeUse& other) const { return lower == other.lower && upper == other.upper; }
};

// All sides of all panels, those of one edge side by side.
std::vector<EdgeUse> edge_uses(const QuadMesh& mesh);

// Calls visit(first, last) for the uses of each edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (std::size_t from = 0; from < uses.size();) {
    std::size_t to = from + 1;
    while (to < uses.size() && uses[to].same_edge(uses[from])) ++to;
    visit(&uses[from], &uses[from] + (to - from));
    from = to;
  }
}

struct EdgeCount {
  int open = 0, branching = 0;  // edges of one panel; of three or more
};
EdgeCount count_edges(const QuadMesh& mesh);

// Why the panels are no oriented manifold surface, how often and where the first place is [m], in words:
// edges of three panels, neighbours that face opposite ways, surfaces that touch in a point. Empty where they
// are one. The panels' points exist.
std::string flaw_of_surface(const QuadMesh& mesh);

// The surfaces the mesh consists of: numbers from 0, one per panel; panels that share an edge are of one.
std::vector<int> surface_of_panel(const QuadMesh& mesh, int& surfaces);

// The panels the function wants, and all points.
template <class Wanted>
QuadMesh with_panels(const QuadMesh& mesh, Wanted wanted) {
  QuadMesh result;
  result.points = mesh.points;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    if (!wanted(k)) continue;
    result.quads.push_back(mesh.quads[k]);
    result.patch.push_back(mesh.patch[k]);
  }
  return result;
}

// Without the points that belong to no panel, which are no part of the hull.
QuadMesh without_unused_points(const QuadMesh& mesh);

double panel_area(const QuadMesh& mesh, std::size_t panel);  //!< [m^2]

}  // namespace icebow
