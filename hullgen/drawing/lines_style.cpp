#include "hullgen/drawing/lines_style.h"

namespace icebow {
namespace {

// On a screen currentColor where the drawing stands in a page; on its own it follows the reader's light or
// dark preference. On paper plain colours: what makes PDF of it knows no variables.
constexpr const char* screen_root = R"(
.lines-plan:root{color:#1d2b36;--lp-paper:#fff;background:var(--lp-paper)}
@media(prefers-color-scheme:dark){.lines-plan:root{color:#dde6ec;--lp-paper:#12181d}})";

struct Colour {
  const char *name, *screen, *print;
};
constexpr Colour colours[] = {{"$ink", "currentColor", "#1d2b36"},
                              {"$paper", "var(--lp-paper,Canvas)", "#ffffff"},
                              {"$water", "var(--lp-water,#2485c7)", "#2485c7"},
                              {"$angle", "var(--lp-angle,#d4572a)", "#d4572a"},
                              {"$second", "var(--lp-second,#8e44ad)", "#8e44ad"}};

// Opacity of fill and stroke only: text in an element with an opacity of its own is no text in a PDF.
constexpr const char* rules = R"(
.lines-plan{font:13px/1 system-ui,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;fill:none;stroke-linecap:round;stroke-linejoin:round}
.lines-plan path,.lines-plan circle{stroke:$ink;stroke-width:1.1}
.lines-plan text{fill:$ink;stroke:none}
.lines-plan .title{font-size:20px;font-weight:600}
.lines-plan .heading{font-weight:600}
.lines-plan .quiet,.lines-plan .scale{fill-opacity:.72;font-size:12px}
.lines-plan .name{font-size:12px}
.lines-plan .name,.lines-plan .scale{paint-order:stroke;stroke:$paper;stroke-width:3px}
.lines-plan path.grid{stroke-width:.6;stroke-opacity:.22}
.lines-plan path.tick{stroke-width:.8;stroke-opacity:.6}
.lines-plan path.centre{stroke-width:.9;stroke-dasharray:14 3 3 3;stroke-opacity:.6}
.lines-plan path.outline{stroke-width:1.9}
.lines-plan path.flat{stroke-width:.9;stroke-dasharray:5 3}
.lines-plan path.dwl{stroke:$water;stroke-width:1.1}
.lines-plan path.dwl-cut{stroke:$water;stroke-width:2}
.lines-plan .dwl-name{fill:$water;fill-opacity:1;font-weight:600}
.lines-plan path.measured,.lines-plan path.arc{stroke:$angle;stroke-width:1.6}
.lines-plan path.ray{stroke:$angle;stroke-width:.9;stroke-dasharray:4 3}
.lines-plan path.leader{stroke:$angle;stroke-width:.8}
.lines-plan circle.point{stroke:none;fill:$angle}
.lines-plan text.angle{fill:$angle;font-weight:600;paint-order:stroke;stroke:$paper;stroke-width:4px;stroke-opacity:.92}
.lines-plan .second path{stroke:$second;stroke-width:1;stroke-dasharray:7 3}
.lines-plan .second path.outline{stroke-width:1.7}
.lines-plan .second path.flat{stroke-width:.9;stroke-dasharray:2 3}
.lines-plan .second text{fill:$second}
)";

}  // namespace

std::string lines_style(DrawnFor reader) {
  std::string style = rules;
  for (const Colour& colour : colours) {
    const std::string name = colour.name, value = reader == DrawnFor::screen ? colour.screen : colour.print;
    for (std::size_t at = style.find(name); at != std::string::npos; at = style.find(name, at + value.size()))
      style.replace(at, name.size(), value);
  }
  return reader == DrawnFor::screen ? screen_root + style : style;
}

}  // namespace icebow
