#include "solver/output/picture_canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace icebow {
namespace {

constexpr int most_pixels = 16000;

// Raster points whose centres lie in [from, to), cut to the raster.
std::pair<int, int> covered(double from, double to, int size) {
  const double first = std::clamp(std::ceil(from - 0.5), 0.0, static_cast<double>(size));
  const double last = std::clamp(std::ceil(to - 0.5), 0.0, static_cast<double>(size));
  return {static_cast<int>(first), static_cast<int>(last)};
}

double distance_to(const Segment& s, const Vec2& p) {
  const Vec2 along = s.second - s.first;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - s.first).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - s.first - t * along).norm();
}

}  // namespace

Color mix(const Color& from, const Color& to, float share) {
  return {from.r + share * (to.r - from.r), from.g + share * (to.g - from.g),
          from.b + share * (to.b - from.b)};
}

Canvas::Canvas(double x_min, double x_max, double y_min, double y_max, int width_px, const Color& background)
    : x_min_(x_min), y_max_(y_max) {
  if (!(x_max > x_min) || !(y_max > y_min) || width_px < 1)
    throw std::invalid_argument("a picture needs a window and a width");
  scale_ = fine * width_px / (x_max - x_min);
  const double height_px = std::max(1.0, std::round((y_max - y_min) * width_px / (x_max - x_min)));
  if (width_px > most_pixels || height_px > most_pixels)
    throw std::invalid_argument("a picture of more than 16000 pixels on a side");
  width_ = fine * width_px;
  height_ = fine * static_cast<int>(height_px);
  points_.assign(static_cast<std::size_t>(width_) * height_,
                 {background, -std::numeric_limits<float>::infinity()});
}

void Canvas::tile(const Eigen::Vector3f& centre, const Eigen::Vector3f& u, const Eigen::Vector3f& v,
                  const Color& color) {
  const Vec2 c = at(centre.head<2>().cast<double>());
  const Vec2 a = Vec2(u.x(), -u.y()) * scale_, b = Vec2(v.x(), -v.y()) * scale_;
  const double determinant = a.x() * b.y() - a.y() * b.x();
  if (!(std::abs(determinant) > 1e-3)) return;  // seen edge-on, or not a number
  const Vec2 reach = 0.52 * (a.cwiseAbs() + b.cwiseAbs());
  const auto [left, right] = covered(c.x() - reach.x(), c.x() + reach.x(), width_);
  const auto [top, bottom] = covered(c.y() - reach.y(), c.y() + reach.y(), height_);
  constexpr double half = 0.515;  // a hair over: neighbours leave no slits
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column) {
      const Vec2 p = Vec2(column + 0.5, row + 0.5) - c;
      const double s = (p.x() * b.y() - p.y() * b.x()) / determinant;
      const double t = (a.x() * p.y() - a.y() * p.x()) / determinant;
      if (std::abs(s) > half || std::abs(t) > half) continue;
      const float z = static_cast<float>(centre.z() + s * u.z() + t * v.z());
      Point& point = points_[static_cast<std::size_t>(row) * width_ + column];
      if (z > point.z) point = {color, z};
    }
}

void Canvas::blend(int column, int row, const Color& color, float opacity) {
  Color& c = points_[static_cast<std::size_t>(row) * width_ + column].color;
  c = mix(c, color, opacity);
}

void Canvas::fill(const std::vector<Segment>& loops, const Color& color, float opacity) {
  std::vector<std::vector<double>> crossings(height_);
  for (const Segment& segment : loops) {
    Vec2 a = at(segment.first), b = at(segment.second);
    if (a.y() > b.y()) std::swap(a, b);
    const auto [top, bottom] = covered(a.y(), b.y(), height_);
    for (int row = top; row < bottom; ++row)
      crossings[row].push_back(a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  for (int row = 0; row < height_; ++row) {
    std::vector<double>& x = crossings[row];
    std::sort(x.begin(), x.end());
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) {
      const auto [left, right] = covered(x[k], x[k + 1], width_);
      for (int column = left; column < right; ++column) blend(column, row, color, opacity);
    }
  }
}

void Canvas::stroke(const std::vector<Segment>& lines, double width_px, const Color& color, float opacity) {
  const double half = 0.5 * width_px * fine;
  std::vector<bool> touched(points_.size(), false);  // overlapping segments darken a point once
  for (const Segment& line : lines) {
    const Segment s{at(line.first), at(line.second)};
    const Vec2 lower = s.first.cwiseMin(s.second), upper = s.first.cwiseMax(s.second);
    const auto [left, right] = covered(lower.x() - half, upper.x() + half, width_);
    const auto [top, bottom] = covered(lower.y() - half, upper.y() + half, height_);
    for (int row = top; row < bottom; ++row)
      for (int column = left; column < right; ++column) {
        const std::size_t number = static_cast<std::size_t>(row) * width_ + column;
        if (touched[number] || distance_to(s, Vec2(column + 0.5, row + 0.5)) > half) continue;
        touched[number] = true;
        blend(column, row, color, opacity);
      }
  }
}

void Canvas::rectangle(double left, double bottom, double right, double top, const Color& color) {
  const auto [first, last] = covered(left * fine, right * fine, width_);
  const auto [upper, lower] = covered(height_ - top * fine, height_ - bottom * fine, height_);
  for (int row = upper; row < lower; ++row)
    for (int column = first; column < last; ++column) blend(column, row, color, 1.0f);
}

Raster Canvas::raster() const {
  Raster picture{width(), height(), {}};
  std::vector<std::uint8_t>& bytes = picture.rgb;
  bytes.reserve(static_cast<std::size_t>(3) * width() * height());
  for (int row = 0; row < height(); ++row)
    for (int column = 0; column < width(); ++column) {
      Color sum;
      for (int k = 0; k < fine * fine; ++k) {
        const Color& c =
            points_[static_cast<std::size_t>(row * fine + k / fine) * width_ + column * fine + k % fine]
                .color;
        sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
      }
      for (float channel : {sum.r, sum.g, sum.b})
        bytes.push_back(static_cast<std::uint8_t>(std::clamp(channel / (fine * fine) + 0.5f, 0.0f, 255.0f)));
    }
  return picture;
}

}  // namespace icebow
