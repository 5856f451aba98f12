#include "study/evaluate/voyage_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hullgen/drawing/svg_canvas.h"

namespace icebow {
namespace {

constexpr double width = 1100.0, left = 70.0, right = 92.0, top = 40.0, plot_height = 190.0, between = 60.0;

const std::vector<StyleRule>& rules() {
  static const std::vector<StyleRule> all = {
      {"", "svg", "", "background:#fff"},
      {"", "text", "", "font-family:sans-serif;font-size:13px;fill:#222222"},
      {"", "text", "title", "font-size:15px"},
      {"", "path", "ice", "fill:#e8eef3;stroke:none"},
      {"", "path", "water", "fill:#9dbdd1;stroke:none"},
      {"", "path", "piece", "fill:#c4d8e5;stroke:#4a6d85;stroke-width:.8"},
      {"", "path", "hull", "fill:#8b5a3c;fill-opacity:.18;stroke:#5a3620"},
      {"", "path", "axis", "stroke:#444444;fill:none"},
      {"", "path", "grid", "stroke:#dddddd;fill:none"},
      {"", "path", "load", "stroke:#9c2f2f;stroke-width:1;fill:none"},
      {"", "path", "mean", "stroke:#222222;stroke-width:1.4;stroke-dasharray:6 4;fill:none"}};
  return all;
}

std::string fixed(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

// 1, 2 or 5 times a power of ten, about a fifth of the range.
double tick_of(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(range, 1e-12) / 5.0)));
  for (double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= 6.5) return factor * power;
  return 10.0 * power;
}

class Picture {
 public:
  Picture(const cycle::VoyageResult& v, double submersion, double way, const std::string& title)
      : v_(v),
        submersion_(submersion),
        to_(v.counted_to),
        from_(std::max(0.0, v.counted_to - way)),
        half_(half_width(v)),
        scale_((width - left - right) / (to_ - from_ + 0.1 * way)),
        canvas_(width, plot_top() + plot_height + 50.0, voyage_style(), title) {
    canvas_.text({left, 22.0}, title, Anchor::start, "title");
  }

  std::string draw(const std::vector<Vec3>& waterline) {
    block(from_, to_ + 0.1 * (to_ - from_), -half_, half_, "ice");
    block(from_, to_ - v_.bow_length, -0.5 * v_.beam, 0.5 * v_.beam, "water");
    for (auto piece = v_.pieces.rbegin(); piece != v_.pieces.rend(); ++piece) outline(*piece);
    ship(waterline);
    loads();
    return canvas_.svg();
  }

 private:
  static double half_width(const cycle::VoyageResult& v) {
    double widest = 0.7 * v.beam;
    for (const cycle::Piece& p : v.pieces) widest = std::max(widest, std::abs(p.y) + p.radius + 1.0);
    return std::min(widest, 1.6 * v.beam);
  }
  double plot_top() const { return top + 2.0 * half_ * scale_ + between; }
  Pixel at(double x, double y) const {
    return {left + (x - from_) * scale_, top + (half_ - std::clamp(y, -half_, half_)) * scale_};
  }
  void block(double x0, double x1, double y0, double y1, const char* kind) {
    if (x1 > x0) canvas_.polyline({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1), at(x0, y0)}, kind);
  }

  void outline(const cycle::Piece& p) {
    if (p.shape.empty() || p.x + p.radius < from_) return;
    std::vector<Pixel> line;
    for (const cycle::Outline& o : p.shape) line.push_back(at(std::max(o.to, from_), o.y));
    for (auto o = p.shape.rbegin(); o != p.shape.rend(); ++o)
      line.push_back(at(std::max(o->from, from_), o->y));
    line.push_back(line.front());
    canvas_.polyline(line, "piece");
  }

  void ship(const std::vector<Vec3>& waterline) {
    std::vector<Pixel> line;
    for (const Vec3& p : waterline) line.push_back(at(std::max(from_, to_ + p.x()), p.y()));
    if (!line.empty()) canvas_.polyline(line, "hull");
  }

  void loads() {
    double largest = 0.0, sum = 0.0;
    int n = 0;
    for (const cycle::Record& r : v_.records) {
      if (r.advance < from_) continue;
      largest = std::max(largest, submersion_ - r.force.x()), sum += submersion_ - r.force.x(), ++n;
    }
    if (n == 0 || largest <= 0.0) return;
    const double bottom = plot_top() + plot_height, per_newton = plot_height / (1.05 * largest);
    axes(largest, bottom, per_newton);
    std::vector<Pixel> line;
    for (const cycle::Record& r : v_.records)
      if (r.advance >= from_)
        line.push_back({at(r.advance, 0).x, bottom - (submersion_ - r.force.x()) * per_newton});
    canvas_.polyline(line, "load");
    const double mean = bottom - sum / n * per_newton;
    canvas_.line({left, mean}, {at(to_, 0).x, mean}, "mean");
    canvas_.text({at(to_, 0).x + 6.0, mean + 4.0}, "mean " + fixed(sum / n / 1e6, 3), Anchor::start, "");
  }

  void axes(double largest, double bottom, double per_newton) {
    for (double load = 0.0; load <= 1.05 * largest; load += tick_of(largest)) {
      const double y = bottom - load * per_newton;
      canvas_.line({left, y}, {at(to_, 0).x, y}, "grid");
      canvas_.text({left - 6.0, y + 4.0}, fixed(load / 1e6, 2), Anchor::end, "");
    }
    const double tick = tick_of(to_ - from_);
    for (double x = std::ceil(from_ / tick) * tick; x <= to_; x += tick) {
      canvas_.line({at(x, 0).x, bottom}, {at(x, 0).x, bottom + 5.0}, "axis");
      canvas_.text({at(x, 0).x, bottom + 19.0}, fixed(x, 0), Anchor::middle, "");
    }
    canvas_.line({left, bottom}, {at(to_, 0).x, bottom}, "axis");
    canvas_.text({left, plot_top() - 10.0}, "resistance, MN", Anchor::start, "");
    canvas_.text({at(to_, 0).x, bottom + 38.0}, "advance of the stem, m", Anchor::end, "");
  }

  const cycle::VoyageResult& v_;
  double submersion_, to_, from_, half_, scale_;
  SvgCanvas canvas_;
};

}  // namespace

std::string voyage_svg(const cycle::VoyageResult& voyage, const std::vector<Vec3>& waterline,
                       double submersion, double way, const std::string& title) {
  return Picture(voyage, submersion, way, title).draw(waterline);
}

const SvgStyle& voyage_style() {
  static const SvgStyle style("voyage", rules());
  return style;
}

}  // namespace icebow
