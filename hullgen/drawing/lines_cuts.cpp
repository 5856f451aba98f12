#include "hullgen/drawing/lines_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "hullgen/bow/family.h"

namespace icebow {
namespace {

constexpr double flat_of_side = 0.9996;   // of the half-breadth: its edge
constexpr double flat_of_bottom = 0.002;  //!< above the keel: its edge [m]

// Largest of 1, 2, 5, 10, 20, ... not above the wanted step.
double round_step(double wanted) {
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double digits = wanted / decade;
  return decade * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

std::vector<LineOfView> stations(const std::vector<double>& distances) {
  std::vector<LineOfView> lines;
  for (double s : distances) lines.push_back({s, "station", metres(s)});
  return lines;
}

// x of the design waterline at a half-breadth.
double foremost_on_waterline(const QuadMesh& mesh, double y) {
  double x = -std::numeric_limits<double>::infinity();
  for (const Polyline& loop : slice(mesh, 2, 0.0))
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) {
      const Vec3 &p = loop[k], &q = loop[k + 1];
      if ((p.y() >= y) == (q.y() >= y)) continue;
      x = std::max(x, p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
    }
  return x;
}

}  // namespace

std::vector<double> multiples(double step, double from, double to) {
  std::vector<double> values;
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
    values.push_back(k * step);
  return values;
}

std::string signed_metres(double value) {
  if (std::abs(value) < 1e-9) return "0";
  return text("%s%g", value < 0.0 ? "\u2212" : "+", std::abs(value));
}
std::string metres(double value) {
  return text("%s%g", value < -1e-9 ? "\u2212" : "", std::abs(value));
}

ForeBody fore_body(const Hull& hull, const BowParameters& bow) {
  ForeBody b{hull, bow, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, {}};
  for (std::size_t q = 0; q < hull.mesh.quads.size(); ++q) {
    if (hull.mesh.patch[q] != Patch::bow) continue;
    for (int corner : hull.mesh.quads[q]) {
      const Vec3& p = hull.mesh.points[corner];
      b.tip = std::min(b.tip, -p.x());
      b.end = std::max(b.end, -p.x());
    }
  }
  b.s1 = -foremost_on_waterline(hull.mesh, bow_beam(bow) / 4.0);
  b.waterline_step = round_step(bow.T / 3.5);
  b.station_step = round_step((bow.Lf - b.tip) / 7.0);
  b.aft_station_step = round_step(std::max(b.end - bow.Lf, 1.0) / 4.0);
  b.extent = {b.tip, std::max(1.06 * b.end, std::min(2.5 * bow.Lf, 1.2 * b.end)), -bow.T, bow.D - bow.T,
              bow_beam(bow) / 2.0};
  return b;
}

void share_extent(ForeBody& a, ForeBody& b) {
  Extent& e = a.extent;
  const Extent& f = b.extent;
  e = {std::min(e.tip, f.tip), std::max(e.window, f.window), std::min(e.low, f.low), std::max(e.high, f.high),
       std::max(e.half, f.half)};
  b.extent = e;
}

std::vector<LineOfView> buttocks(const ForeBody& own, const ForeBody& spacing) {
  std::vector<LineOfView> lines{{flat_of_side * bow_beam(own.bow) / 2.0, "flat", "side"}};
  for (double share : {0.75, 0.5, 0.25}) {
    const double y = share * bow_beam(spacing.bow) / 2.0;
    lines.push_back({y, "buttock", text("%.2f", y)});
  }
  lines.push_back({0.0, "outline", "CL"});
  return lines;
}

std::vector<double> waterline_heights(const ForeBody& b) {
  std::vector<double> heights;
  for (double z : multiples(b.waterline_step, -b.bow.T, b.bow.D - b.bow.T))
    if (z > -b.bow.T + 0.1 && z < b.bow.D - b.bow.T - 0.1) heights.push_back(z);
  return heights;
}

std::vector<LineOfView> waterlines(const ForeBody& own, const ForeBody& spacing) {
  std::vector<LineOfView> lines;
  for (double z : waterline_heights(spacing)) {
    const bool dwl = std::abs(z) < 1e-9;
    lines.push_back({z, dwl ? "dwl-cut" : "waterline", dwl ? "DWL" : signed_metres(z)});
  }
  lines.push_back({own.bow.D - own.bow.T, "outline", "deck"});
  lines.push_back({-own.bow.T + flat_of_bottom, "flat", "flat of bottom"});
  return lines;
}

std::vector<LineOfView> fore_stations(const ForeBody& spacing) {
  return stations(multiples(spacing.station_step, spacing.extent.tip + 0.1, spacing.bow.Lf));
}
std::vector<LineOfView> aft_stations(const ForeBody& spacing) {
  return stations(multiples(spacing.aft_station_step, spacing.bow.Lf + 0.1, spacing.end - 0.1));
}

void draw_cut(SvgCanvas& svg, const View& view, const std::vector<Polyline>& cut, int across, int up,
              double sign, const std::vector<ViewLimit>& limits, const std::string& style_class) {
  std::vector<Polyline> parts = cut;
  for (const ViewLimit& limit : limits) {
    std::vector<Polyline> kept;
    for (const Polyline& part : parts)
      for (Polyline& piece : clipped(part, limit.axis, limit.lower)) kept.push_back(std::move(piece));
    parts = std::move(kept);
  }
  for (const Polyline& part : parts) {
    std::vector<Pixel> pixels;
    for (const Vec3& p : part) pixels.push_back(view.at(sign * p[across], p[up]));
    svg.polyline(pixels, style_class);
  }
}

Vec3 extreme_point(const std::vector<Polyline>& cut, Extreme first, Extreme second) {
  Vec3 best = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  for (const Polyline& loop : cut)
    for (const Vec3& p : loop) {
      const double lead = first.sign * (p[first.axis] - best[first.axis]);
      const bool tie = std::abs(lead) < 1e-6 && second.sign * (p[second.axis] - best[second.axis]) > 0.0;
      if (std::isnan(best[0]) || lead >= 1e-6 || tie) best = p;
    }
  return best;
}

}  // namespace icebow
