// An SVG drawing, element by element, with labels that keep off each other.
#pragma once

#include <string>
#include <vector>

#include "hullgen/drawing/svg_style.h"

namespace icebow {

struct Pixel {
  double x = 0.0, y = 0.0;  // y down
};

enum class Anchor { start, middle, end };

class SvgCanvas {
 public:
  // `title` is the drawing's accessible name. Elements bear their look as attributes; for a screen a <style>
  // holds over them. The style outlives the canvas.
  SvgCanvas(double width, double height, const SvgStyle& style, const std::string& title,
            DrawnFor reader = DrawnFor::screen);

  void begin_group(const std::string& style_class);
  void end_group();
  // Points closer to the line through their neighbours than a tenth of a pixel are left out.
  void polyline(const std::vector<Pixel>& points, const std::string& style_class);
  void line(Pixel a, Pixel b, const std::string& style_class);
  void dot(Pixel centre, double radius, const std::string& style_class);
  // Circular arc from angle a to angle b [rad], counter-clockwise as seen, 0 along +x.
  void arc(Pixel centre, double radius, double a, double b, const std::string& style_class);
  void text(Pixel at, const std::string& words, Anchor anchor, const std::string& style_class);
  // Text at that of at + shift (at itself first) that covers no earlier label and the fewest lines drawn so
  // far, the first of several; left out if all cover a label. Lines of the classes "grid", "tick" and
  // "centre" may be covered.
  bool label(Pixel at, const std::string& words, Anchor anchor, const std::string& style_class,
             const std::vector<Pixel>& shifts = {});

  std::string svg() const;

 private:
  struct Rectangle {
    double x0, y0, x1, y1;
  };
  struct Segment {
    Pixel a, b;
  };
  static bool crosses(const Segment& segment, const Rectangle& box);
  int lines_under(const Rectangle& box) const;

  std::string look(const char* element, const std::string& style_class) const;

  const SvgStyle& style_;
  std::string group_;
  std::string out_;
  std::vector<Segment> segments_;  // of the lines that labels keep off
  std::vector<Rectangle> labels_;
};

std::string xml_escaped(const std::string& words);

}  // namespace icebow
