#include "hullgen/drawing/lines_plan.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/drawing/lines_views.h"

namespace icebow {
namespace {

// The sheet [px]: profile above half-breadth plan in the left column, body plan above the table in the right
// one.
constexpr double width = 1312.0, left_margin = 62.0, left_column = 712.0, right_column = 330.0, gap = 100.0;
constexpr double title_height = 98.0, label_room = 40.0, scale_room = 62.0, row_height = 21.0;

std::string dimensions(const BowParameters& bow) {
  return text(
      "L %g m \u00b7 B %g m \u00b7 T %g m \u00b7 D %g m \u00b7 bow length on the design waterline %.5g m",
      bow.L, bow.B, bow.T, bow.D, bow.Lf);
}

// Rows of a table whose columns after the first and before the last are numbers.
class Table {
 public:
  Table(SvgCanvas& svg, Pixel corner) : svg_(svg), corner_(corner), y_(corner.y) {}

  void head(const char* angle, const char* first, const char* second, const char* place) {
    write(angle, first, second, place, "heading", "heading");
    svg_.line({corner_.x, y_ + 8.0}, {corner_.x + right_column, y_ + 8.0}, "tick");
    y_ += 4.0;
  }
  void row(const char* angle, const std::string& first, const std::string& second, const char* place) {
    y_ += row_height;
    write(angle, first, second, place, "cell", "cell quiet");
  }

 private:
  void write(const char* angle, const std::string& first, const std::string& second, const char* place,
             const char* cell, const char* last_cell) {
    svg_.text({corner_.x, y_}, angle, Anchor::start, cell);
    svg_.text({corner_.x + 150.0, y_}, first, Anchor::end, cell);
    svg_.text({corner_.x + 220.0, y_}, second, Anchor::end, cell);
    svg_.text({corner_.x + 236.0, y_}, place, Anchor::start, last_cell);
  }
  SvgCanvas& svg_;
  Pixel corner_;
  double y_;
};

std::string degree_text(double angle) {
  return std::isfinite(angle) ? text("%.2f", degrees(angle)) : std::string("\u2013");
}

// Asked for, measured, and where.
void draw_angles(SvgCanvas& svg, Pixel corner, const Hull& hull) {
  Table table(svg, corner);
  const BowAngles &a = hull.requested, &m = hull.measured;
  table.head("Angle [deg]", "asked", "mesh", "at");
  table.row("stem", degree_text(a.stem), degree_text(m.stem), "CL, DWL");
  table.row("waterline", degree_text(a.waterline), degree_text(m.waterline), "CL, DWL");
  table.row("buttock", degree_text(a.buttock), degree_text(m.buttock), "B/4, DWL");
  table.row("flare", degree_text(a.flare), degree_text(m.flare), "B/4, DWL");
  table.row("waterline", "derived", degree_text(hull.waterline_at_quarter_beam), "B/4, DWL");
  table.row("flare", "derived", degree_text(hull.flare_at_stem), "CL, DWL");
}

// The angles of two hulls, as measured on their meshes.
void draw_angles(SvgCanvas& svg, Pixel corner, const Hull& first, const Hull& second) {
  Table table(svg, corner);
  const BowAngles &a = first.measured, &b = second.measured;
  table.head("Angle [deg]", "solid", "dashed", "at");
  table.row("stem", degree_text(a.stem), degree_text(b.stem), "CL, DWL");
  table.row("waterline", degree_text(a.waterline), degree_text(b.waterline), "CL, DWL");
  table.row("buttock", degree_text(a.buttock), degree_text(b.buttock), "B/4, DWL");
  table.row("flare", degree_text(a.flare), degree_text(b.flare), "B/4, DWL");
  table.row("waterline", degree_text(first.waterline_at_quarter_beam),
            degree_text(second.waterline_at_quarter_beam), "B/4, DWL");
  table.row("flare", degree_text(first.flare_at_stem), degree_text(second.flare_at_stem), "CL, DWL");
}

void draw_heading(SvgCanvas& svg, Pixel at, const std::string& view, const std::string& lines) {
  svg.text(at, view, Anchor::start, "heading");
  svg.text({at.x + 8.2 * static_cast<double>(view.size()) + 8.0, at.y}, lines, Anchor::start, "quiet");
}

std::string no_lines(const Hull& hull, const std::string& title, DrawnFor reader) {
  SvgCanvas svg(width, 120.0, lines_style(), title, reader);
  svg.text({left_margin, 40.0}, title, Anchor::start, "title");
  svg.text({left_margin, 76.0}, "No hull, so no lines: " + hull.reason, Anchor::start, "quiet");
  return svg.svg();
}

// Where views and table stand on the sheet.
struct Sheet {
  explicit Sheet(const Extent& e)
      : profile{{0.0, 0.0}, left_column / (e.window - e.tip)},
        plan{profile},
        body_plan{{0.0, 0.0}, right_column / (2.0 * e.half)} {
    const double across = left_margin + profile.scale * e.window;
    profile.origin = {across, profile_top + profile.scale * e.high};
    plan_top = profile_top + (e.high - e.low) * profile.scale + scale_room + 1.5 * label_room;
    plan.origin = {across, plan_top + profile.scale * e.half};
    body_plan.origin = {right + right_column / 2.0, profile_top + body_plan.scale * e.high};
    table_top = profile_top + (e.high - e.low) * body_plan.scale + label_room + 24.0;
    height = std::max(plan.origin.y + scale_room + 14.0, table_top + 7.0 * row_height + 20.0);
  }
  static constexpr double profile_top = title_height + 2.0 * label_room;
  static constexpr double right = left_margin + left_column + gap;
  View profile, plan, body_plan;
  double plan_top, table_top, height;
};

void draw_headings(SvgCanvas& svg, const Sheet& sheet, double low) {
  const double top = Sheet::profile_top - 1.5 * label_room;
  draw_heading(svg, {left_margin, top}, "Profile", "buttocks by half-breadth, m");
  draw_heading(svg, {left_margin, sheet.plan_top - label_room}, "Half-breadth plan",
               "waterlines by height, m");
  draw_heading(svg, {Sheet::right, top}, "Body plan", "stations by distance aft of the stem, m");
  svg.text({Sheet::right + right_column, sheet.body_plan.at(0.0, low).y + 20.0},
           "right: up to the shoulder; left: aft of it", Anchor::end, "quiet");
}

void draw_views(SvgCanvas& svg, const Sheet& sheet, const ForeBody& body) {
  draw_profile(svg, body, sheet.profile);
  draw_half_breadth(svg, body, sheet.plan);
  draw_body_plan(svg, body, sheet.body_plan);
}

// A piece of line, and the hull's name, family and dimensions.
void draw_legend(SvgCanvas& svg, double y, const NamedHull& hull) {
  svg.line({left_margin, y - 4.0}, {left_margin + 44.0, y - 4.0}, "outline");
  svg.text({left_margin + 56.0, y}, hull.name + ": " + hull.hull.form + ", " + dimensions(hull.bow),
           Anchor::start, "cell");
}

}  // namespace

std::string lines_plan_svg(const Hull& hull, const BowParameters& bow, const std::string& title,
                           DrawnFor reader) {
  if (hull.mesh.quads.empty()) return no_lines(hull, title, reader);
  const ForeBody body = fore_body(hull, bow);
  const Sheet sheet(body.extent);
  SvgCanvas svg(width, sheet.height, lines_style(), title, reader);
  svg.text({left_margin, 36.0}, title, Anchor::start, "title");
  svg.text({left_margin, 60.0}, dimensions(bow), Anchor::start, "cell");
  svg.text({left_margin, 80.0},
           hull.form +
               "; full scale, metres from the stem at the "
               "design waterline",
           Anchor::start, "quiet");
  draw_headings(svg, sheet, body.extent.low);
  draw_views(svg, sheet, body);
  draw_angles(svg, {Sheet::right, sheet.table_top}, hull);
  return svg.svg();
}

std::string overlaid_lines_plan_svg(const NamedHull& first, const NamedHull& second, const std::string& title,
                                    DrawnFor reader) {
  ForeBody a = fore_body(first.hull, first.bow), b = fore_body(second.hull, second.bow);
  share_extent(a, b);
  const Sheet sheet(a.extent);
  SvgCanvas svg(width, sheet.height, lines_style(), title, reader);
  svg.text({left_margin, 36.0}, title, Anchor::start, "title");
  draw_legend(svg, 62.0, first);
  svg.begin_group("second");
  draw_legend(svg, 84.0, second);
  svg.end_group();
  draw_headings(svg, sheet, a.extent.low);
  overlay_profile(svg, b, a, sheet.profile);
  overlay_half_breadth(svg, b, a, sheet.plan);
  overlay_body_plan(svg, b, a, sheet.body_plan);
  draw_views(svg, sheet, a);
  draw_angles(svg, {Sheet::right, sheet.table_top}, first.hull, second.hull);
  return svg.svg();
}

}  // namespace icebow
