#include "hullgen/bow/bow_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "hullgen/bow/spacing.h"

namespace icebow {
namespace {

constexpr double growth = 0.15;                // of the wanted edge length per length away from the ice belt
constexpr double coarsest_below = 3.0;         // times the panel size, on the bow below the ice belt
constexpr double coarsest_above = 1.5;         // and above it, where the buttocks turn up
constexpr double bilge_resolution = 5.0;       // cells per bilge radius
constexpr double largest_turn = radians(8.0);  // in one panel, where the family is graded by curvature,
constexpr double rounding_cells = 8.0;         // a panel's share that a column of the stem's rounding has,
constexpr double most_cells = 6.0;             // but no more columns than this
constexpr double turn_on_rounding = radians(12.0);  // in one of them
constexpr double longest_on_knife = 3.0;            // times the panel size, along the ship
constexpr double smallest_panel = 0.5;  // but no panel smaller than this times the wanted size for it

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

// Columns inside these lines: the rounding turns little in one of them, the ice knife is not drawn out.
std::vector<double> centre_columns(const BowSurface& bow, const std::vector<double>& ends, double panel) {
  const double ahead = bow.knife(0.0, -bow.T), whole_turn = std::atan(bow.c0);
  std::vector<double> columns{0.0};
  for (const double end : ends) {
    const double from = columns.back(), width = end - from;
    // On the rounding by equal angles: eta goes with the sine.
    const double turn = end <= bow.stem_half_width && from == 0.0 ? whole_turn : 0.0;
    double cells = std::max(width / panel, std::min(width * rounding_cells / panel, turn / turn_on_rounding));
    if (end <= bow.knife_half_width)
      cells = std::max(cells, ahead * width / bow.knife_half_width / (longest_on_knife * panel));
    const int n = static_cast<int>(std::ceil(std::clamp(cells, 1.0, most_cells)));
    for (int k = 1; k < n; ++k) {
      const double share = static_cast<double>(k) / n;
      columns.push_back(from + width * (turn > 0.0 ? std::sin(turn * share) / std::sin(turn) : share));
    }
    columns.push_back(end);
  }
  return columns;
}

}  // namespace

std::vector<double> centre_lines(const BowSurface& bow, std::vector<double> more) {
  more.push_back(bow.stem_half_width);
  more.push_back(bow.knife_half_width);
  std::sort(more.begin(), more.end());
  std::vector<double> lines;
  for (const double eta : more)
    if (eta > (lines.empty() ? 0.0 : lines.back()) + 1e-9 * bow.half_beam()) lines.push_back(eta);
  return lines;
}

BowGrid bow_grid(const BowSurface& bow, double panel, bool by_curvature, std::vector<double> required) {
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
  if (bow.knife_half_width > 0.0) {
    grid.z = lines(buttock, -bow.belt_below, bow.knife_top, outside, 1);
    append(grid.z, lines(buttock, bow.knife_top, -bow.T, outside, 3));
  } else {
    grid.z = lines(buttock, -bow.belt_below, -bow.T, outside, 4);
  }
  std::reverse(grid.z.begin(), grid.z.end());
  append(grid.z, lines(buttock, -bow.belt_below, 0.0, belt, 2));
  append(grid.z, lines(buttock, 0.0, bow.belt_above, belt, 2));
  append(grid.z, lines(buttock, bow.belt_above, bow.D - bow.T, outside, 3));
  grid.eta = centre_columns(bow, centre_lines(bow, std::move(required)), panel);
  append(grid.eta, lines(waterline, grid.eta.back(), bow.yq, belt, 4));
  const double crease = bow.yq * (1.0 + bow.chine);
  if (bow.chine > 0.0) append(grid.eta, lines(waterline, bow.yq, crease, belt, 2));
  append(grid.eta, lines(waterline, crease, bow.half_beam(), belt, 4));
  return grid;
}

}  // namespace icebow
