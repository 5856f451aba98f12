#include "solver/watch/cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/units.h"
#include "geometry/second_moments.h"
#include "geometry/union_find.h"

namespace icebow {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr int neighbourhood = 2;         // columns
constexpr double shortest = 2.0;         // thicknesses
constexpr double edge_effect = 2.0;      // thicknesses
constexpr double splitting_reach = 3.0;  // characteristic lengths
const double splitting_angle = radians(30.0);

struct Site {
  std::int64_t i, j;
  Vec2 place;  //!< in the hull's frame when it opened [m]
  double x;    //!< in the sheet [m]
  double opened, from_hull, along_course;
  CrackKind kind;
};

struct Nearest {
  Vec2 ray = Vec2::Zero();  // from the waterline, not normalised
  bool inside = false;      // of the waterline
  double along = nan_value;
};

Nearest nearest(const std::vector<Segment>& waterline, const Vec2& p) {
  Nearest result;
  double least = std::numeric_limits<double>::infinity(), front = -least;
  for (const auto& [a, b] : waterline) {
    const Vec2 edge = b - a;
    const double t = std::clamp((p - a).dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec2 ray = p - (a + t * edge);
    if (ray.squaredNorm() < least) {
      least = ray.squaredNorm();
      result.ray = ray;
    }
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * edge.x();
    front = std::max(front, x);
    if (x > p.x()) result.inside = !result.inside;
  }
  if (p.x() >= front && std::isfinite(front)) result.along = p.x() - front;
  return result;
}

CrackKind kind_of(const CrackedColumn& c, double y, const Nearest& hull, const CrackedSheet& sheet) {
  if (std::abs(y) > sheet.held_beyond - edge_effect * sheet.thickness) return CrackKind::held_edge;
  if (hull.inside) return CrackKind::secondary;
  if (c.crushed - c.opened <= sheet.thickness) return CrackKind::crushed;
  const double normal = 0.5 * std::atan2(c.sin2, c.cos2);
  const double ray = std::atan2(hull.ray.y(), hull.ray.x());
  return std::abs(std::cos(normal - ray)) > std::sqrt(0.5) ? CrackKind::circumferential : CrackKind::radial;
}

std::vector<Site> sites_of(const CrackedSheet& sheet, const std::vector<Segment>& waterline) {
  std::vector<Site> sites;
  const Lattice& lattice = sheet.lattice;
  for (const CrackedColumn& column : sheet.columns) {
    for (int side = 0; side < lattice.copies(); ++side) {
      CrackedColumn c = column;
      if (side == 1) {  // its mirror image
        c.j = -1 - c.j;
        c.sin2 = -c.sin2;
      }
      const double x = (double(c.i) + 0.5) * lattice.dx;
      const Vec2 place(x - sheet.first_touch_x - c.opened, lattice.y(static_cast<int>(c.j)));
      const Nearest hull = nearest(waterline, place);
      sites.push_back({c.i, c.j, place, x, c.opened, hull.inside ? 0.0 : hull.ray.norm(),
                       hull.inside ? nan_value : hull.along, kind_of(c, place.y(), hull, sheet)});
    }
  }
  return sites;
}

bool together(const Site& a, const Site& b, double thickness) {
  return a.kind == b.kind && std::abs(a.opened - b.opened) <= thickness;
}

std::vector<std::vector<Site>> clusters(const std::vector<Site>& sites, double thickness) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::int32_t> at;
  for (std::size_t n = 0; n < sites.size(); ++n) at[{sites[n].i, sites[n].j}] = static_cast<std::int32_t>(n);
  UnionFind set(sites.size());
  for (std::size_t n = 0; n < sites.size(); ++n) {
    for (int di = 0; di <= neighbourhood; ++di) {
      for (int dj = di == 0 ? 1 : -neighbourhood; dj <= neighbourhood; ++dj) {
        const auto other = at.find({sites[n].i + di, sites[n].j + dj});
        if (other != at.end() && together(sites[n], sites[other->second], thickness))
          set.join(static_cast<std::int32_t>(n), other->second);
      }
    }
  }
  std::map<std::int32_t, std::vector<Site>> members;
  for (std::size_t n = 0; n < sites.size(); ++n)
    members[set.find(static_cast<std::int32_t>(n))].push_back(sites[n]);
  std::vector<std::vector<Site>> result;
  for (auto& [root, list] : members) result.push_back(std::move(list));
  return result;
}

double mean_of(const std::vector<Site>& sites, double Site::*value) {
  double sum = 0.0;
  int n = 0;
  for (const Site& s : sites) {
    if (!std::isfinite(s.*value)) continue;
    sum += s.*value;
    ++n;
  }
  return n > 0 ? sum / n : nan_value;
}

Crack describe(const std::vector<Site>& sites, const CrackedSheet& sheet) {
  const Site* first = &sites.front();
  double ahead = first->place.x();
  SecondMoments moments;
  for (const Site& s : sites) {
    moments.add(s.x, s.place.y());
    ahead = std::max(ahead, s.place.x());
    if (s.opened < first->opened || (s.opened == first->opened && s.from_hull < first->from_hull)) first = &s;
  }
  const MainAxes axes = moments.axes(sheet.lattice.dx);
  Crack crack;
  crack.kind = first->kind;
  crack.opened = first->opened;
  crack.x = first->place.x();
  crack.y = first->place.y();
  crack.length = axes.length;
  crack.direction = axes.direction;
  crack.from_hull = mean_of(sites, &Site::from_hull);
  crack.along_course = mean_of(sites, &Site::along_course);
  crack.columns = static_cast<int>(sites.size());
  if (crack.kind == CrackKind::radial && std::abs(crack.direction) < splitting_angle &&
      ahead > splitting_reach * sheet.characteristic_length)
    crack.kind = CrackKind::splitting;
  return crack;
}

bool too_short(const Crack& crack, const CrackedSheet& sheet) {
  return crack.kind != CrackKind::crushed && crack.length < shortest * sheet.thickness;
}

}  // namespace

std::vector<CrackedPlace> cracked_places(const CrackedSheet& sheet, const std::vector<Segment>& waterline) {
  std::vector<CrackedPlace> places;
  for (const std::vector<Site>& sites : clusters(sites_of(sheet, waterline), sheet.thickness)) {
    const Crack crack = describe(sites, sheet);
    if (too_short(crack, sheet)) continue;
    for (const Site& s : sites) places.push_back({s.x, s.place.y(), crack.kind});
  }
  return places;
}

Cracks find_cracks(const CrackedSheet& sheet, const std::vector<Segment>& waterline) {
  Cracks cracks;
  for (const std::vector<Site>& sites : clusters(sites_of(sheet, waterline), sheet.thickness)) {
    const Crack crack = describe(sites, sheet);
    if (too_short(crack, sheet)) {
      cracks.isolated += crack.columns;
      continue;
    }
    cracks.columns[static_cast<int>(crack.kind)] += crack.columns;
    cracks.list.push_back(crack);
  }
  std::stable_sort(cracks.list.begin(), cracks.list.end(),
                   [](const Crack& a, const Crack& b) { return a.opened < b.opened; });
  return cracks;
}

}  // namespace icebow
