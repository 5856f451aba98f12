#include "hullgen/drawing/svg_canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"

namespace icebow {
namespace {

constexpr double glyph_width = 6.6, glyph_height = 12.0;  // of label text, generous

double distance_to_chord(const Pixel& p, const Pixel& a, const Pixel& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length < 1e-12) return std::hypot(p.x - a.x, p.y - a.y);
  return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / length;
}

// Ramer, Douglas and Peucker: marks the points between first and last that the drawn line needs.
void mark_needed(const std::vector<Pixel>& points, std::size_t first, std::size_t last,
                 std::vector<char>& needed) {
  double farthest = 0.1;
  std::size_t split = 0;
  for (std::size_t k = first + 1; k < last; ++k) {
    const double d = distance_to_chord(points[k], points[first], points[last]);
    if (d > farthest) farthest = d, split = k;
  }
  if (split == 0) return;
  needed[split] = 1;
  mark_needed(points, first, split, needed);
  mark_needed(points, split, last, needed);
}

const char* anchor_name(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

std::size_t glyphs(const std::string& utf8) {
  return std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

}  // namespace

std::string xml_escaped(const std::string& words) {
  std::string out;
  for (char c : words) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

SvgCanvas::SvgCanvas(double width, double height, const SvgStyle& style, const std::string& title,
                     DrawnFor reader)
    : style_(style) {
  out_ = icebow::text(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"%s\" viewBox=\"0 0 %g %g\" width=\"%g\" "
      "height=\"%g\" role=\"img\"",
      style.drawing().c_str(), width, height, width, height);
  out_ += style.attributes("svg", "") + ">\n<title>" + xml_escaped(title) + "</title>\n";
  if (reader == DrawnFor::screen) out_ += "<style>" + style.css() + "</style>\n";
}

std::string SvgCanvas::look(const char* element, const std::string& style_class) const {
  return style_.attributes(element, style_class, group_);
}

void SvgCanvas::begin_group(const std::string& style_class) {
  out_ += "<g class=\"" + style_class + "\">\n";
  group_ = style_class;
}
void SvgCanvas::end_group() {
  out_ += "</g>\n";
  group_.clear();
}

void SvgCanvas::polyline(const std::vector<Pixel>& points, const std::string& style_class) {
  if (points.size() < 2) return;
  std::vector<char> needed(points.size(), 0);
  needed.front() = needed.back() = 1;
  mark_needed(points, 0, points.size() - 1, needed);
  const bool kept_off = style_class != "grid" && style_class != "tick" && style_class != "centre";
  out_ += "<path class=\"" + style_class + "\" d=\"";
  for (std::size_t k = 0, last = 0; k < points.size(); ++k) {
    if (!needed[k]) continue;
    out_ += icebow::text("%s%.1f %.1f", k == 0 ? "M" : "L", points[k].x, points[k].y);
    if (kept_off && k > 0) segments_.push_back({points[last], points[k]});
    last = k;
  }
  out_ += "\"" + look("path", style_class) + "/>\n";
}

void SvgCanvas::line(Pixel a, Pixel b, const std::string& style_class) {
  polyline({a, b}, style_class);
}

void SvgCanvas::dot(Pixel centre, double radius, const std::string& style_class) {
  out_ += icebow::text("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%g\"%s/>\n", style_class.c_str(),
                       centre.x, centre.y, radius, look("circle", style_class).c_str());
}

void SvgCanvas::arc(Pixel centre, double radius, double a, double b, const std::string& style_class) {
  const auto at = [&](double angle) {
    return Pixel{centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
  };
  const Pixel from = at(a), to = at(b);
  out_ +=
      icebow::text("<path class=\"%s\" d=\"M%.1f %.1fA%.1f %.1f 0 0 0 %.1f %.1f\"%s/>\n", style_class.c_str(),
                   from.x, from.y, radius, radius, to.x, to.y, look("path", style_class).c_str());
}

void SvgCanvas::text(Pixel at, const std::string& words, Anchor anchor, const std::string& style_class) {
  out_ += icebow::text("<text class=\"%s\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", style_class.c_str(),
                       at.x, at.y, anchor_name(anchor), look("text", style_class).c_str());
  out_ += xml_escaped(words) + "</text>\n";
}

// Liang and Barsky: the part of the segment inside both pairs of sides is not empty.
bool SvgCanvas::crosses(const Segment& segment, const Rectangle& box) {
  double from = 0.0, to = 1.0;
  const auto clip = [&](double start, double change, double low, double high) {
    if (change == 0.0) return start > low && start < high;
    const double t0 = (low - start) / change, t1 = (high - start) / change;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    return from < to;
  };
  return clip(segment.a.x, segment.b.x - segment.a.x, box.x0, box.x1) &&
         clip(segment.a.y, segment.b.y - segment.a.y, box.y0, box.y1);
}

int SvgCanvas::lines_under(const Rectangle& box) const {
  return static_cast<int>(std::count_if(segments_.begin(), segments_.end(),
                                        [&](const Segment& segment) { return crosses(segment, box); }));
}

bool SvgCanvas::label(Pixel at, const std::string& words, Anchor anchor, const std::string& style_class,
                      const std::vector<Pixel>& shifts) {
  std::vector<Pixel> places{at};
  for (const Pixel& shift : shifts) places.push_back({at.x + shift.x, at.y + shift.y});
  const double width = glyph_width * static_cast<double>(glyphs(words));
  const double left = anchor == Anchor::start ? 0.0 : anchor == Anchor::middle ? 0.5 * width : width;
  const Pixel* best = nullptr;
  Rectangle best_box{};
  int fewest = std::numeric_limits<int>::max();
  for (const Pixel& p : places) {
    const Rectangle box{p.x - left - 3.0, p.y - glyph_height, p.x - left + width + 3.0, p.y + 2.0};
    const bool covers = std::any_of(labels_.begin(), labels_.end(), [&](const Rectangle& r) {
      return box.x0 < r.x1 && r.x0 < box.x1 && box.y0 < r.y1 && r.y0 < box.y1;
    });
    const int lines = covers ? fewest : lines_under(box);
    if (lines >= fewest) continue;
    best = &p, best_box = box, fewest = lines;
  }
  if (!best) return false;
  labels_.push_back(best_box);
  text(*best, words, anchor, style_class);
  return true;
}

std::string SvgCanvas::svg() const {
  return out_ + "</svg>\n";
}

}  // namespace icebow
