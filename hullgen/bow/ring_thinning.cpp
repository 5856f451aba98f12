#include "hullgen/bow/ring_thinning.h"

#include <algorithm>

namespace icebow {
namespace {

constexpr double coarsest_aft = 8.0;     // times the panel size, towards the transom
constexpr double longest_chord = 0.5;    // of the bilge radius, so that the bilge stays round
constexpr double shortest_chord = 0.25;  // what is left of joining up to that
constexpr double lowest_row =
    1.0 / 12.0;                        // of the bilge radius, at the keel; the transom has it at full width
constexpr double slenderest = 10.0;    // wanted limit of a panel's longest over its shortest edge
constexpr double splinter = 0.25;      // of the wanted length: joined to a neighbour
constexpr double farthest_bend = 0.5;  // of a cell: a node farther aft than its neighbours stays
constexpr double overlong = 1.5;       // up to this times the wanted length

}  // namespace

RingThinning::RingThinning(const BowSurface& bow, const BowGrid& grid, double kept, double panel)
    : panel_(panel), bilge_(bow.bilge), columns_(grid.eta.size(), 1), rows_(grid.z.size(), 1) {
  while (grid.z[static_cast<std::size_t>(bilge_rows_)] < bow.bilge - bow.T) ++bilge_rows_;
  while (grid.eta[static_cast<std::size_t>(fixed_column_)] < kept - 1e-9 * bow.half_beam()) ++fixed_column_;
}

double RingThinning::longest_cell() const {
  return std::min(coarsest_aft * panel_, slenderest * shortest_chord * bilge_);
}

void RingThinning::advance(double cell, const std::function<Vec3(GridNode)>& place) {
  const int side = static_cast<int>(columns_.size()) - 1, deck = static_cast<int>(rows_.size()) - 1;
  const auto distance = [&](GridNode a, GridNode b) { return (place(a) - place(b)).norm(); };
  join(
      rows_, bilge_rows_,
      [&](int a, int b) {
        return distance({side, a}, {side, b});
      },
      [&](int i) { return i < bilge_rows_ ? std::min(cell, longest_chord * bilge_) : cell; },
      [](int, int, int) { return false; });
  const double widest = std::min(cell, slenderest * lowest_row * bilge_);
  join(
      columns_, fixed_column_,
      [&](int a, int b) {
        return std::max(distance({a, 0}, {b, 0}), distance({a, deck}, {b, deck}));
      },
      [&](int) { return widest; },
      // Panels would fold where the root of an ice knife, say, lies farther aft than the next station.
      [&](int a, int b, int c) {
        const Vec3 from = place({a, 0}), middle = place({b, 0}), to = place({c, 0});
        const double share = (middle.y() - from.y()) / std::max(to.y() - from.y(), 1e-9);
        return from.x() + share * (to.x() - from.x()) - middle.x() > farthest_bend * cell;
      });
}

void RingThinning::join(std::vector<char>& kept, int fixed, const Length& length, const Limit& longest,
                        const Bend& bent) {
  std::vector<int> nodes;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (kept[k]) nodes.push_back(static_cast<int>(k));
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k) {
    const int a = nodes[k - 1], b = nodes[k], c = nodes[k + 1];
    if (b == fixed) continue;
    const double wanted = longest(b), together = length(a, c);
    const bool short_one = std::min(length(a, b), length(b, c)) < splinter * wanted;
    if (together > (short_one ? overlong : 1.0) * wanted) continue;
    if (bent(a, b, c)) continue;
    kept[static_cast<std::size_t>(b)] = 0;
    ++k;  // the next one is the neighbour of the one that went
  }
}

}  // namespace icebow
