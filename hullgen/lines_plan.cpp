#include "hullgen/lines_plan.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hullgen/bow_surface.h"
#include "hullgen/lines_views.h"
#include "hullgen/text.h"

namespace icebow {
namespace {

// The sheet [px]: profile above half-breadth plan in the left column, body plan above the table in the right
// one.
constexpr double width = 1312.0, left_margin = 62.0, left_column = 712.0, right_column = 330.0, gap = 100.0;
constexpr double title_height = 98.0, label_room = 40.0, scale_room = 62.0;

// currentColor where the drawing stands in a page; on its own it follows the reader's light or dark
// preference.
constexpr const char* style = R"(
.lines-plan{font:13px/1 system-ui,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;fill:none;stroke-linecap:round;stroke-linejoin:round}
.lines-plan:root{color:#1d2b36;--lp-paper:#fff;background:var(--lp-paper)}
@media(prefers-color-scheme:dark){.lines-plan:root{color:#dde6ec;--lp-paper:#12181d}}
.lines-plan path,.lines-plan circle{stroke:currentColor;stroke-width:1.1}
.lines-plan text{fill:currentColor;stroke:none}
.lines-plan .title{font-size:20px;font-weight:600}
.lines-plan .heading{font-weight:600}
.lines-plan .quiet,.lines-plan .scale{opacity:.72;font-size:12px}
.lines-plan .name{font-size:12px}
.lines-plan path.grid{stroke-width:.6;opacity:.22}
.lines-plan path.tick{stroke-width:.8;opacity:.6}
.lines-plan path.centre{stroke-width:.9;stroke-dasharray:14 3 3 3;opacity:.6}
.lines-plan path.outline{stroke-width:1.9}
.lines-plan path.flat{stroke-width:.9;stroke-dasharray:5 3}
.lines-plan path.dwl{stroke:var(--lp-water,#2485c7);stroke-width:1.1}
.lines-plan path.dwl-cut{stroke:var(--lp-water,#2485c7);stroke-width:2}
.lines-plan .dwl-name{fill:var(--lp-water,#2485c7);opacity:1;font-weight:600}
.lines-plan path.measured,.lines-plan path.arc{stroke:var(--lp-angle,#d4572a);stroke-width:1.6}
.lines-plan path.ray{stroke:var(--lp-angle,#d4572a);stroke-width:.9;stroke-dasharray:4 3}
.lines-plan circle.point{stroke:none;fill:var(--lp-angle,#d4572a)}
.lines-plan text.angle{fill:var(--lp-angle,#d4572a);font-weight:600;paint-order:stroke;stroke:var(--lp-paper,Canvas);stroke-width:4px}
)";

std::string dimensions(const BowParameters& bow) {
  return text(
      "L %g m \u00b7 B %g m \u00b7 T %g m \u00b7 D %g m \u00b7 bow length on the design waterline %.5g m",
      bow.L, bow.B, bow.T, bow.D, bow.Lf);
}

// A table of the four angles: asked for, measured, and where.
void draw_table(SvgCanvas& svg, Pixel corner, const Hull& hull) {
  const double columns[] = {corner.x, corner.x + 150.0, corner.x + 220.0, corner.x + 236.0};
  double y = corner.y;
  svg.text({columns[0], y}, "Angle [deg]", Anchor::start, "heading");
  svg.text({columns[1], y}, "asked", Anchor::end, "heading");
  svg.text({columns[2], y}, "mesh", Anchor::end, "heading");
  svg.text({columns[3], y}, "at", Anchor::start, "heading");
  svg.line({corner.x, y + 8.0}, {corner.x + right_column, y + 8.0}, "tick");
  const auto row = [&](const char* name, const std::string& asked, double measured, const char* where) {
    y += 21.0;
    svg.text({columns[0], y + 4.0}, name, Anchor::start, "cell");
    svg.text({columns[1], y + 4.0}, asked, Anchor::end, "cell");
    svg.text({columns[2], y + 4.0}, text("%.2f", degrees(measured)), Anchor::end, "cell");
    svg.text({columns[3], y + 4.0}, where, Anchor::start, "cell quiet");
  };
  const auto asked = [](double angle) {
    return std::isfinite(angle) ? text("%.2f", degrees(angle)) : std::string("\u2013");
  };
  row("stem", asked(hull.requested.stem), hull.measured.stem, "CL, DWL");
  row("waterline", asked(hull.requested.waterline), hull.measured.waterline, "CL, DWL");
  row("buttock", asked(hull.requested.buttock), hull.measured.buttock, "B/4, DWL");
  row("flare", asked(hull.requested.flare), hull.measured.flare, "B/4, DWL");
  row("waterline", "derived", hull.waterline_at_quarter_beam, "B/4, DWL");
  row("flare", "derived", hull.flare_at_stem, "CL, DWL");
}

void draw_heading(SvgCanvas& svg, Pixel at, const std::string& view, const std::string& lines) {
  svg.text(at, view, Anchor::start, "heading");
  svg.text({at.x + 8.2 * static_cast<double>(view.size()) + 8.0, at.y}, lines, Anchor::start, "quiet");
}

std::string no_lines(const Hull& hull, const std::string& title) {
  SvgCanvas svg(width, 120.0, "lines-plan", style, title);
  svg.text({left_margin, 40.0}, title, Anchor::start, "title");
  svg.text({left_margin, 76.0}, "No hull, so no lines: " + hull.reason, Anchor::start, "quiet");
  return svg.svg();
}

}  // namespace

std::string lines_plan_svg(const Hull& hull, const BowParameters& bow, const std::string& title) {
  if (hull.mesh.quads.empty()) return no_lines(hull, title);
  const ForeBody body = fore_body(hull, bow);
  const double scale = left_column / (body.window - body.tip);
  const double deck = bow.D - bow.T, half = bow_beam(bow) / 2.0;
  const double profile_top = title_height + 2.0 * label_room;
  const double plan_top = profile_top + bow.D * scale + scale_room + 1.5 * label_room;
  const View profile{{left_margin + scale * body.window, profile_top + scale * deck}, scale};
  const View plan{{profile.origin.x, plan_top + scale * half}, scale};
  const double body_scale = right_column / bow_beam(bow), right = left_margin + left_column + gap;
  const View body_plan{{right + right_column / 2.0, profile_top + body_scale * deck}, body_scale};
  const double table_top = profile_top + bow.D * body_scale + label_room + 24.0;
  const double height = std::max(plan.origin.y + scale_room + 14.0, table_top + 7.0 * 21.0 + 20.0);

  SvgCanvas svg(width, height, "lines-plan", style, title);
  svg.text({left_margin, 36.0}, title, Anchor::start, "title");
  svg.text({left_margin, 60.0}, dimensions(bow), Anchor::start, "cell");
  svg.text({left_margin, 80.0},
           hull.form +
               "; full scale, metres from the stem at the "
               "design waterline",
           Anchor::start, "quiet");
  draw_heading(svg, {left_margin, profile_top - 1.5 * label_room}, "Profile", "buttocks by half-breadth, m");
  draw_heading(svg, {left_margin, plan_top - label_room}, "Half-breadth plan", "waterlines by height, m");
  draw_heading(svg, {right, profile_top - 1.5 * label_room}, "Body plan",
               "stations by distance aft of the stem, m");
  svg.text({right + right_column, body_plan.at(0.0, -bow.T).y + 20.0},
           "right: up to the shoulder; left: aft of it", Anchor::end, "quiet");
  draw_profile(svg, body, profile);
  draw_half_breadth(svg, body, plan);
  draw_body_plan(svg, body, body_plan);
  draw_table(svg, {right, table_top}, hull);
  return svg.svg();
}

}  // namespace icebow
