#include "hullgen/drawing/lines_views.h"

#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/family.h"

namespace icebow {
namespace {

constexpr double mark = 46.0;  // radius of an angle's arc [px]

// Rays at the angles a < b [rad] from a point with the arc between them and a label beyond it, where it
// covers the fewest lines.
void draw_angle(SvgCanvas& svg, Pixel at, double a, double b, const std::string& words, Pixel label,
                Anchor anchor) {
  for (double angle : {a, b})
    svg.line(at, {at.x + 1.35 * mark * std::cos(angle), at.y - 1.35 * mark * std::sin(angle)}, "ray");
  svg.arc(at, mark, a, b, "arc");
  svg.dot(at, 2.6, "point");
  std::vector<Pixel> shifts;
  for (double down : {0.0, 14.0, 28.0, -14.0, 42.0})
    for (double right : {0.0, 24.0, -24.0, 48.0, -48.0}) shifts.push_back({right, down});
  svg.label({at.x + label.x, at.y + label.y}, words, anchor, "angle", shifts);
}

std::string angle_words(const char* name, double angle) {
  return text("%s %.2f\u00b0", name, degrees(angle));
}

std::vector<double> length_marks(const ForeBody& b, const View& view) {
  return multiples(view.scale < 13.0 ? 10.0 : 5.0, b.extent.tip, b.extent.window);
}

// Scale of metres aft of the stem below the profile; the half-breadth plan stands under it.
void draw_length_scale(SvgCanvas& svg, const ForeBody& b, const View& view, double low) {
  const double y = view.at(0.0, low).y + 20.0;
  for (double s : length_marks(b, view)) {
    const double x = view.at(-s, low).x;
    svg.line({x, y}, {x, y + 5.0}, "tick");
    svg.label({x, y + 18.0}, metres(s), Anchor::middle, "scale");
  }
  svg.line({view.at(-b.extent.window, low).x, y}, {view.at(-b.extent.tip, low).x, y}, "tick");
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

void draw_profile(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const Extent& e = b.extent;
  draw_length_scale(svg, b, view, e.low);
  draw_length_grid(svg, b, view, e.low, e.high);
  draw_height_grid(svg, b, view, -e.window, -e.tip + 3.0);
  for (double z : waterline_heights(b)) {
    const bool dwl = std::abs(z) < 1e-9;
    const Pixel p = view.at(-e.window, z);
    svg.label({p.x - 8.0, p.y + 4.0}, dwl ? "DWL" : signed_metres(z), Anchor::end,
              dwl ? "scale dwl-name" : "scale");
  }
  for (const LineOfView& line : buttocks(b, b)) {
    const auto cut = slice(b.hull.mesh, 1, line.at);
    draw_cut(svg, view, cut, 0, 2, 1.0, {{0, -e.window}}, line.style_class);
    const Vec3 top = extreme_point(cut, {2, 1.0}, {0, 1.0});
    const Pixel p = view.at(top.x(), top.z());
    svg.label({p.x, p.y - 7.0}, line.name, Anchor::middle, "name", {{0, -14}, {0, -28}, {0, -42}});
  }
  const BowAngles& a = b.hull.measured;
  draw_angle(svg, view.at(0.0, 0.0), 0.0, a.stem, angle_words("stem", a.stem), {12.0, 18.0}, Anchor::start);
  // Buttocks run close to each other at P1: its label stands ahead of the stem, where there are no lines.
  const Pixel quarter = view.at(-b.s1, 0.0), label{view.at(0.0, 0.0).x + 12.0, quarter.y + 44.0};
  svg.line(quarter, {label.x - 5.0, label.y - 4.0}, "leader");
  draw_angle(svg, quarter, 0.0, a.buttock, angle_words("buttock", a.buttock),
             {label.x - quarter.x, label.y - quarter.y}, Anchor::start);
}

void draw_half_breadth(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const double half = bow_beam(b.bow) / 2.0, forward = -b.extent.tip + 3.0, aft = -b.extent.window;
  svg.line(view.at(aft, 0.0), view.at(forward, 0.0), "centre");
  draw_length_grid(svg, b, view, 0.0, b.extent.half);
  for (double share : {0.25, 0.5, 0.75, 1.0}) {
    const Pixel p = view.at(aft, share * half);
    svg.line(p, view.at(forward, share * half), "grid");
    svg.label({p.x - 8.0, p.y + 4.0}, text("%.2f", share * half), Anchor::end, "scale");
  }
  for (const LineOfView& line : waterlines(b, b)) {
    const auto cut = slice(b.hull.mesh, 2, line.at);
    draw_cut(svg, view, cut, 0, 1, 1.0, {{0, aft}, {1, 0.0}}, line.style_class);
    const Vec3 shoulder = extreme_point(cut, {1, 1.0}, {0, 1.0});
    const Pixel p = view.at(shoulder.x(), b.extent.half);
    svg.label({p.x, p.y - 7.0}, line.name, Anchor::middle,
              line.style_class == "dwl-cut" ? "name dwl-name" : "name", {{0, -14}, {0, -28}, {0, -42}});
  }
  const double a = b.hull.measured.waterline;
  draw_angle(svg, view.at(0.0, 0.0), -a, 0.0, angle_words("waterline", a),
             {30.0, 1.35 * mark * std::sin(a) + 18.0}, Anchor::middle);
}

void draw_body_plan(SvgCanvas& svg, const ForeBody& b, const View& view) {
  const double half = bow_beam(b.bow) / 2.0, deck = b.bow.D - b.bow.T;
  draw_height_grid(svg, b, view, -b.extent.half, b.extent.half);
  svg.line(view.at(0.0, b.extent.low), view.at(0.0, b.extent.high), "centre");
  for (double share : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75})
    svg.line(view.at(share * half, -b.bow.T), view.at(share * half, deck), "grid");

  const auto station = [&](double s, double sign, const std::string& style_class) {
    const auto cut = slice(b.hull.mesh, 0, -s);
    draw_cut(svg, view, cut, 1, 2, sign, {{1, 0.0}}, style_class);
    return cut;
  };
  station(b.s1, 1.0, "measured");  // below the outline
  const Pixel dwl = view.at(b.extent.half, 0.0);
  svg.label({dwl.x + 8.0, dwl.y + 4.0}, "DWL", Anchor::start, "scale dwl-name");
  for (double sign : {-1.0, 1.0}) station(b.extent.window, sign, "outline");
  for (const LineOfView& line : fore_stations(b)) {
    const auto cut = station(line.at, 1.0, line.style_class);
    if (cut.empty()) continue;  // ahead of the bow, where the sheet has room for another one
    const Vec3 side = extreme_point(cut, {1, 1.0}, {2, -1.0}), top = extreme_point(cut, {2, 1.0}, {1, 1.0});
    const bool below_deck = side.z() < deck - 0.1;  // reaches the side, else the deck
    const Pixel p = below_deck ? view.at(side.y(), side.z()) : view.at(top.y(), top.z());
    svg.label(below_deck ? Pixel{p.x + 6.0, p.y + 4.0} : Pixel{p.x, p.y - 7.0}, line.name,
              below_deck ? Anchor::start : Anchor::middle, "name");
  }
  for (const LineOfView& line : aft_stations(b)) {
    const Vec3 side = extreme_point(station(line.at, -1.0, line.style_class), {1, 1.0}, {2, -1.0});
    const Pixel p = view.at(-side.y(), side.z());
    svg.label({p.x - 6.0, p.y + 4.0}, line.name, Anchor::end, "name", {{0, 13}, {0, -13}});
  }
  const double flare = b.hull.measured.flare;
  draw_angle(svg, view.at(half / 2.0, 0.0), pi / 2.0 - flare, pi / 2.0, angle_words("flare", flare),
             {view.scale * (b.extent.half - half / 2.0) + 8.0, 22.0}, Anchor::start);
}

void overlay_profile(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view) {
  svg.begin_group("second");
  for (const LineOfView& line : buttocks(second, first))
    draw_cut(svg, view, slice(second.hull.mesh, 1, line.at), 0, 2, 1.0, {{0, -second.extent.window}},
             line.style_class);
  svg.end_group();
}

void overlay_half_breadth(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view) {
  svg.begin_group("second");
  for (const LineOfView& line : waterlines(second, first))
    draw_cut(svg, view, slice(second.hull.mesh, 2, line.at), 0, 1, 1.0,
             {{0, -second.extent.window}, {1, 0.0}}, line.style_class);
  svg.end_group();
}

void overlay_body_plan(SvgCanvas& svg, const ForeBody& second, const ForeBody& first, const View& view) {
  const auto draw = [&](const LineOfView& line, double sign) {
    draw_cut(svg, view, slice(second.hull.mesh, 0, -line.at), 1, 2, sign, {{1, 0.0}}, line.style_class);
  };
  svg.begin_group("second");
  for (const LineOfView& line : fore_stations(first)) draw(line, 1.0);
  for (const LineOfView& line : aft_stations(first)) draw(line, -1.0);
  for (double sign : {-1.0, 1.0}) draw({second.extent.window, "outline", ""}, sign);
  svg.end_group();
}

}  // namespace icebow
