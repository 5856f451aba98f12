// A small raster with depth: tiles, filled loops and lines in metres, antialiased by drawing at twice the
// size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/hull_section.h"
#include "solver/output/raster.h"

namespace icebow {

struct Color {
  float r = 0, g = 0, b = 0;  // 0..255, sRGB
};

Color mix(const Color& from, const Color& to, float share);

class Canvas {
 public:
  static constexpr int fine = 2;  // raster points per pixel, along each side

  // The window in metres; y points up in the picture. Throws std::invalid_argument where it is empty or has
  // more than 16,000 pixels on a side.
  Canvas(double x_min, double x_max, double y_min, double y_max, int width_px, const Color& background);

  int width() const { return width_ / fine; }
  int height() const { return height_ / fine; }
  double metres_per_pixel() const { return fine / scale_; }

  // The parallelogram centre + s u + t v, -1/2 <= s, t <= 1/2; hidden where something higher (z) was drawn.
  void tile(const Eigen::Vector3f& centre, const Eigen::Vector3f& u, const Eigen::Vector3f& v,
            const Color& color);
  // Inside of closed loops (even-odd), over everything.
  void fill(const std::vector<Segment>& loops, const Color& color, float opacity);
  void stroke(const std::vector<Segment>& lines, double width_px, const Color& color, float opacity);
  // A rectangle in pixels from the lower left corner.
  void rectangle(double left, double bottom, double right, double top, const Color& color);

  // Mean of each pixel's raster points.
  Raster raster() const;

 private:
  struct Point {
    Color color;
    float z;
  };

  Vec2 at(const Vec2& p) const { return {(p.x() - x_min_) * scale_, (y_max_ - p.y()) * scale_}; }
  void blend(int column, int row, const Color& color, float opacity);

  double x_min_, y_max_, scale_;  // scale: raster points per metre
  int width_, height_;            // in raster points
  std::vector<Point> points_;
};

}  // namespace icebow
