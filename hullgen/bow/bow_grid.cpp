#include "hullgen/bow/bow_grid.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow/spacing.h"

namespace icebow {
namespace {

constexpr double growth = 0.15;                // of the wanted edge length per length away from the ice belt
constexpr double coarsest_below = 3.0;         // times the panel size, on the bow below the ice belt
constexpr double coarsest_above = 1.5;         // and above it, where the buttocks turn up
constexpr double bilge_resolution = 5.0;       // cells per bilge radius
constexpr double largest_turn = radians(8.0);  // in one panel, where the family is graded by curvature,
constexpr double smallest_panel = 0.5;         // but no panel smaller than this times the wanted size for it

void append(std::vector<double>& lines, const std::vector<double>& more) {
  lines.insert(lines.end(), more.begin() + 1, more.end());
}

// The wanted cells, smaller where the curve turns by more than the largest turn in one of them.
CellLength turning_slowly(const Curve& curve, double u0, double u1, double panel, const CellLength& wanted) {
  return [=](double u, double length) {
    const double turning = largest_turn * curvature_radius(curve, u0, u1, u);
    return std::min(wanted(u, length), std::max(turning, smallest_panel * panel));
  };
}

}  // namespace

BowGrid bow_grid(const BowSurface& bow, double panel, bool by_curvature) {
  // Rows follow the buttock at the side, which also takes in the bilge; columns follow the design waterline.
  const Curve buttock = [&](double z) { return bow.point(bow.half_beam(), z); };
  const Curve waterline = [&](double eta) { return bow.point(eta, 0.0); };
  const CellLength belt = [&](double, double) { return panel; };
  const CellLength outside = [&](double z, double length) {
    const double cap = z > 0.0 ? coarsest_above : coarsest_below;
    const double away = std::min(panel + growth * length, cap * panel);
    return z < bow.bilge - bow.T ? std::min(away, bow.bilge / bilge_resolution) : away;
  };
  const auto lines = [&](const Curve& curve, double u0, double u1, const CellLength& cell, int min_cells) {
    return graded(curve, u0, u1, by_curvature ? turning_slowly(curve, u0, u1, panel, cell) : cell, min_cells);
  };
  BowGrid grid;
  grid.z = lines(buttock, -bow.belt_below, -bow.T, outside, 4);
  std::reverse(grid.z.begin(), grid.z.end());
  append(grid.z, lines(buttock, -bow.belt_below, 0.0, belt, 2));
  append(grid.z, lines(buttock, 0.0, bow.belt_above, belt, 2));
  append(grid.z, lines(buttock, bow.belt_above, bow.D - bow.T, outside, 3));
  grid.eta = lines(waterline, 0.0, bow.yq, belt, 4);
  const double crease = bow.yq * (1.0 + bow.chine);
  if (bow.chine > 0.0) append(grid.eta, lines(waterline, bow.yq, crease, belt, 2));
  append(grid.eta, lines(waterline, crease, bow.half_beam(), belt, 4));
  return grid;
}

}  // namespace icebow
