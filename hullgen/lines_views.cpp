#include "hullgen/lines_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "hullgen/family.h"
#include "hullgen/mesh_slice.h"
#include "hullgen/text.h"

namespace icebow {
namespace {

constexpr double mark = 46.0;  // radius of an angle's arc [px]

// Largest of 1, 2, 5, 10, 20, ... not above the wanted step.
double round_step(double wanted) {
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double digits = wanted / decade;
  return decade * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

std::vector<double> multiples(double step, double from, double to) {
  std::vector<double> values;
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
    values.push_back(k * step);
  return values;
}

// "-2", "+3", "0"; a true minus sign reads better in a drawing.
std::string signed_metres(double value) {
  if (std::abs(value) < 1e-9) return "0";
  return text("%s%g", value < 0.0 ? "\u2212" : "+", std::abs(value));
}
std::string metres(double value) {
  return text("%s%g", value < -1e-9 ? "\u2212" : "", std::abs(value));
}

// What a view leaves out: the part of a line with point[axis] < lower.
struct Limit {
  int axis;
  double lower;
};

// Draws a plane's cut in a view that shows the axes `across` (times sign) and `up`.
void draw_cut(SvgCanvas& svg, const View& view, const std::vector<Polyline>& cut, int across, int up,
              double sign, const std::vector<Limit>& limits, const char* style_class) {
  std::vector<Polyline> parts = cut;
  for (const Limit& limit : limits) {
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

// The point of a cut that is extreme in `first`; among equals, in `second` (each +1/-1 times an axis).
struct Extreme {
  int axis;
  double sign;
};
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

// Rays at the angles a < b [rad] from a point with the arc between them and a label beyond it.
void draw_angle(SvgCanvas& svg, Pixel at, double a, double b, const std::string& words, Pixel label,
                Anchor anchor) {
  for (double angle : {a, b})
    svg.line(at, {at.x + 1.35 * mark * std::cos(angle), at.y - 1.35 * mark * std::sin(angle)}, "ray");
  svg.arc(at, mark, a, b, "arc");
  svg.dot(at, 2.6, "point");
  svg.label({at.x + label.x, at.y + label.y}, words, anchor, "angle", {{0, 14}, {0, -14}, {0, 28}});
}

std::string angle_words(const char* name, double angle) {
  return text("%s %.2f\u00b0", name, degrees(angle));
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

std::vector<double> waterline_heights(const ForeBody& b) {
  std::vector<double> heights;
  for (double z : multiples(b.waterline_step, -b.bow.T, b.bow.D - b.bow.T))
    if (z > -b.bow.T + 0.1 && z < b.bow.D - b.bow.T - 0.1) heights.push_back(z);
  return heights;
}

std::vector<double> length_marks(const ForeBody& b, const View& view) {
  return multiples(view.scale < 13.0 ? 10.0 : 5.0, b.tip, b.window);
}

// Scale of metres aft of the stem below the profile; the half-breadth plan stands under it.
void draw_length_scale(SvgCanvas& svg, const ForeBody& b, const View& view, double low) {
  const double y = view.at(0.0, low).y + 20.0;
  for (double s : length_marks(b, view)) {
    const double x = view.at(-s, low).x;
    svg.line({x, y}, {x, y + 5.0}, "tick");
    svg.label({x, y + 18.0}, metres(s), Anchor::middle, "scale");
  }
  svg.line({view.at(-b.window, low).x, y}, {view.at(-b.tip, low).x, y}, "tick");
}

void draw_length_grid(SvgCanvas& svg, const ForeBody& b, const View& view, double low, double high) {
  for (double s : length_marks(b, view)) svg.line(view.at(-s, low), view.at(-s, high), "grid");
}

// Where the lines stand in the view seen edge-on.
void draw_height_grid(SvgCanvas& svg, const ForeBody& b, const View& view, double left, double right) {
  std::vector<double> heights = waterline_heights(b);
  heights.push_back(-b.bow.T);
  heights.push_back(b.bow.D - b.bow.T);
  for (double z : heights) {
    const bool waterline = std::abs(z) < 1e-9;
    svg.line(view.at(left, z), view.at(right, z), waterline ? "dwl" : "grid");
  }
}

}  // namespace

ForeBody fore_body(const Hull& hull, const BowParameters& bow) {
  ForeBody b{hull, bow, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (std::size_t q = 0; q < hull.mesh.quads.size(); ++q) {
    if (hull.mesh.patch[q] != Patch::bow) continue;
    for (int corner : hull.mesh.quads[q]) {
      const Vec3& p = hull.mesh.points[corner];
      b.tip = std::min(b.tip, -p.x());
      b.end = std::max(b.end, -p.x());
    }
  }
  b.s1 = -foremost_on_waterline(hull.mesh, bow_beam(bow) / 4.0);
  b.window = std::max(1.06 * b.end, std::min(2.5 * bow.Lf, 1.2 * b.end));
  b.waterline_step = round_step(bow.T / 3.5);
  b.station_step = round_step((bow.Lf - b.tip) / 7.0);
  b.aft_station_step = round_step(std::max(b.end - bow.Lf, 1.0) / 4.0);
  return b;
}

void draw_profile(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const double deck = b.bow.D - b.bow.T, forward = -b.tip + 3.0;
  draw_length_scale(svg, b, view, -b.bow.T);
  draw_length_grid(svg, b, view, -b.bow.T, deck);
  draw_height_grid(svg, b, view, -b.window, forward);
  for (double z : waterline_heights(b)) {
    const bool dwl = std::abs(z) < 1e-9;
    const Pixel p = view.at(-b.window, z);
    svg.label({p.x - 8.0, p.y + 4.0}, dwl ? "DWL" : signed_metres(z), Anchor::end,
              dwl ? "scale dwl-name" : "scale");
  }
  for (double share :
       {0.9996, 0.75, 0.5, 0.25, 0.0}) {  // of the half-beam; the first is the edge of the flat of side
    const double y = share * bow_beam(b.bow) / 2.0;
    const auto cut = slice(b.hull.mesh, 1, y);
    draw_cut(svg, view, cut, 0, 2, 1.0, {{0, -b.window}},
             share == 0.0  ? "outline"
             : share > 0.9 ? "flat"
                           : "buttock");
    const Vec3 top = extreme_point(cut, {2, 1.0}, {0, 1.0});
    const Pixel p = view.at(top.x(), top.z());
    const std::string name = share == 0.0 ? "CL" : share > 0.9 ? "side" : text("%.2f", y);
    svg.label({p.x, p.y - 7.0}, name, Anchor::middle, "name", {{0, -14}, {0, -28}, {0, -42}});
  }
  const BowAngles& a = b.hull.measured;
  draw_angle(svg, view.at(0.0, 0.0), 0.0, a.stem, angle_words("stem", a.stem), {12.0, 18.0}, Anchor::start);
  draw_angle(svg, view.at(-b.s1, 0.0), 0.0, a.buttock, angle_words("buttock", a.buttock), {0.0, 18.0},
             Anchor::middle);
}

void draw_half_breadth(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const double half = bow_beam(b.bow) / 2.0, forward = -b.tip + 3.0;
  svg.line(view.at(-b.window, 0.0), view.at(forward, 0.0), "centre");
  draw_length_grid(svg, b, view, 0.0, half);
  for (double share : {0.25, 0.5, 0.75, 1.0}) {
    const Pixel p = view.at(-b.window, share * half);
    svg.line(p, view.at(forward, share * half), "grid");
    svg.label({p.x - 8.0, p.y + 4.0}, text("%.2f", share * half), Anchor::end, "scale");
  }
  std::vector<double> heights = waterline_heights(b);
  heights.push_back(b.bow.D - b.bow.T);
  heights.push_back(-b.bow.T + 0.002);  // edge of the flat bottom
  for (double z : heights) {
    const bool dwl = std::abs(z) < 1e-9, deck = z == b.bow.D - b.bow.T, flat = z < -b.bow.T + 0.1;
    const auto cut = slice(b.hull.mesh, 2, z);
    draw_cut(svg, view, cut, 0, 1, 1.0, {{0, -b.window}, {1, 0.0}},
             dwl    ? "dwl-cut"
             : deck ? "outline"
             : flat ? "flat"
                    : "waterline");
    const Vec3 shoulder = extreme_point(cut, {1, 1.0}, {0, 1.0});
    const Pixel p = view.at(shoulder.x(), half);
    svg.label({p.x, p.y - 7.0},
              dwl    ? "DWL"
              : deck ? "deck"
              : flat ? "flat of bottom"
                     : signed_metres(z),
              Anchor::middle, dwl ? "name dwl-name" : "name", {{0, -14}, {0, -28}, {0, -42}});
  }
  const double a = b.hull.measured.waterline;
  draw_angle(svg, view.at(0.0, 0.0), -a, 0.0, angle_words("waterline", a),
             {30.0, 1.35 * mark * std::sin(a) + 18.0}, Anchor::middle);
}

void draw_body_plan(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const double half = bow_beam(b.bow) / 2.0, deck = b.bow.D - b.bow.T;
  draw_height_grid(svg, b, view, -half, half);
  svg.line(view.at(0.0, -b.bow.T), view.at(0.0, deck), "centre");
  for (double share : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75})
    svg.line(view.at(share * half, -b.bow.T), view.at(share * half, deck), "grid");

  const auto station = [&](double s, double sign, const char* style_class) {
    const auto cut = slice(b.hull.mesh, 0, -s);
    draw_cut(svg, view, cut, 1, 2, sign, {{1, 0.0}}, style_class);
    return cut;
  };
  station(b.s1, 1.0, "measured");  // below the outline
  const Pixel dwl = view.at(half, 0.0);
  svg.label({dwl.x + 8.0, dwl.y + 4.0}, "DWL", Anchor::start, "scale dwl-name");
  for (double sign : {-1.0, 1.0}) station(b.window, sign, "outline");
  const double flare = b.hull.measured.flare;
  draw_angle(svg, view.at(half / 2.0, 0.0), pi / 2.0 - flare, pi / 2.0, angle_words("flare", flare),
             {view.scale * half / 2.0 + 8.0, 22.0}, Anchor::start);
  for (double s : multiples(b.station_step, b.tip + 0.1, b.bow.Lf)) {
    const auto cut = station(s, 1.0, "station");
    const Vec3 side = extreme_point(cut, {1, 1.0}, {2, -1.0}), top = extreme_point(cut, {2, 1.0}, {1, 1.0});
    const bool below_deck = side.z() < deck - 0.1;  // reaches the side, else the deck
    const Pixel p = below_deck ? view.at(side.y(), side.z()) : view.at(top.y(), top.z());
    svg.label(below_deck ? Pixel{p.x + 6.0, p.y + 4.0} : Pixel{p.x, p.y - 7.0}, metres(s),
              below_deck ? Anchor::start : Anchor::middle, "name");
  }
  for (double s : multiples(b.aft_station_step, b.bow.Lf + 0.1, b.end - 0.1)) {
    const Vec3 side = extreme_point(station(s, -1.0, "station"), {1, 1.0}, {2, -1.0});
    const Pixel p = view.at(-side.y(), side.z());
    svg.label({p.x - 6.0, p.y + 4.0}, metres(s), Anchor::end, "name", {{0, 13}, {0, -13}});
  }
}

}  // namespace icebow
