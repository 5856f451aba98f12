#include "hullgen/drawing/lines_style.h"

namespace icebow {
namespace {

// currentColor where the drawing stands in a page; on its own it follows the reader's light or dark
// preference.
constexpr const char* screen_root = R"(
.lines-plan:root{color:#1d2b36;--lp-paper:#fff;background:var(--lp-paper)}
@media(prefers-color-scheme:dark){.lines-plan:root{color:#dde6ec;--lp-paper:#12181d}}
)";

const std::vector<StyleColour>& colours() {
  static const std::vector<StyleColour> all = {{"ink", "currentColor", "#1d2b36"},
                                               {"paper", "var(--lp-paper,Canvas)", "#ffffff"},
                                               {"water", "var(--lp-water,#2485c7)", "#2485c7"},
                                               {"angle", "var(--lp-angle,#d4572a)", "#d4572a"},
                                               {"second", "var(--lp-second,#8e44ad)", "#8e44ad"}};
  return all;
}

// Opacity of fill and stroke only: text in an element with an opacity of its own is no text in a PDF.
const std::vector<StyleRule>& rules() {
  static const std::vector<StyleRule> all = {
      {"", "svg", "",
       "font-family:system-ui,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;font-size:13px;fill:none;"
       "stroke-linecap:round;stroke-linejoin:round"},
      {"", "path", "", "stroke:$ink;stroke-width:1.1"},
      {"", "circle", "", "stroke:$ink;stroke-width:1.1"},
      {"", "text", "", "fill:$ink;stroke:none"},
      {"", "text", "title", "font-size:20px;font-weight:600"},
      {"", "text", "heading", "font-weight:600"},
      {"", "text", "quiet", "fill-opacity:.72;font-size:12px"},
      {"", "text", "scale",
       "fill-opacity:.72;font-size:12px;paint-order:stroke;stroke:$paper;stroke-width:3px"},
      {"", "text", "name", "font-size:12px;paint-order:stroke;stroke:$paper;stroke-width:3px"},
      {"", "path", "grid", "stroke-width:.6;stroke-opacity:.22"},
      {"", "path", "tick", "stroke-width:.8;stroke-opacity:.6"},
      {"", "path", "centre", "stroke-width:.9;stroke-dasharray:14 3 3 3;stroke-opacity:.6"},
      {"", "path", "outline", "stroke-width:1.9"},
      {"", "path", "flat", "stroke-width:.9;stroke-dasharray:5 3"},
      {"", "path", "buttock", ""},
      {"", "path", "waterline", ""},
      {"", "path", "station", ""},
      {"", "text", "cell", ""},
      {"", "path", "dwl", "stroke:$water;stroke-width:1.1"},
      {"", "path", "dwl-cut", "stroke:$water;stroke-width:2"},
      {"", "text", "dwl-name", "fill:$water;fill-opacity:1;font-weight:600"},
      {"", "path", "measured", "stroke:$angle;stroke-width:1.6"},
      {"", "path", "arc", "stroke:$angle;stroke-width:1.6"},
      {"", "path", "ray", "stroke:$angle;stroke-width:.9;stroke-dasharray:4 3"},
      {"", "path", "leader", "stroke:$angle;stroke-width:.8"},
      {"", "circle", "point", "stroke:none;fill:$angle"},
      {"", "text", "angle",
       "fill:$angle;font-weight:600;paint-order:stroke;stroke:$paper;stroke-width:4px;stroke-opacity:.92"},
      {"second", "path", "", "stroke:$second;stroke-width:1;stroke-dasharray:7 3"},
      {"second", "path", "outline", "stroke-width:1.7"},
      {"second", "path", "flat", "stroke-width:.9;stroke-dasharray:2 3"},
      {"second", "text", "", "fill:$second"}};
  return all;
}

}  // namespace

const SvgStyle& lines_style() {
  static const SvgStyle style("lines-plan", rules(), colours(), screen_root);
  return style;
}

}  // namespace icebow
