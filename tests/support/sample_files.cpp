#include "tests/support/sample_files.h"

#include <png.h>

#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "base/errors.h"
#include "base/units.h"

namespace icebow {
namespace {

constexpr double half_beam = 11.5;  //!< [m]

// Metres aft of the stem at half breadth y.
double aft(double y, double waterline_deg, double bow_length) {
  const double start = std::min(y / std::tan(radians(waterline_deg)), bow_length);
  const double t = y / half_beam;
  return (1.0 - t * t) * start + t * t * bow_length;
}

struct Rgb {
  unsigned char r, g, b;
};

// Floes as cells of scattered seeds inside the channel, level ice outside, a hull at the end of it.
class Scene {
 public:
  Scene(double advance, unsigned seed) : advance_(advance), random_(seed) {
    std::uniform_real_distribution<double> x(0.0, 3.0), y(-0.62, 0.62);
    for (int i = 0; i < 220; ++i) seeds_.push_back({x(random_), y(random_)});
  }

  Rgb at(double x, double y) const {
    const double behind = advance_ - x;
    const double hull = behind < 0.0 ? -1.0 : std::min(0.46, 0.5 * behind);
    if (std::abs(std::abs(y) - hull) < 0.008 && behind > 0.0) return {30, 40, 60};
    const double edge = 0.52 + 0.03 * std::sin(9.0 * x) + 0.02 * std::sin(23.0 * x);
    if (behind < -0.12 || std::abs(y) > edge) return {226, 234, 240};
    double nearest = 9.0, second = 9.0;
    std::size_t cell = 0;
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      const double d = std::hypot(x - seeds_[i].first, y - seeds_[i].second);
      if (d < nearest) {
        second = nearest;
        nearest = d;
        cell = i;
      } else if (d < second) {
        second = d;
      }
    }
    if (std::abs(y) < hull) return {150, 168, 184};
    if (second - nearest < 0.012) return {38, 66, 92};
    const auto tint = static_cast<unsigned char>(cell * 37 % 40);
    return {static_cast<unsigned char>(178 + tint), static_cast<unsigned char>(200 + tint / 2), 224};
  }

 private:
  double advance_;
  std::mt19937 random_;
  std::vector<std::pair<double, double>> seeds_;
};

}  // namespace

std::string sample_hull_obj(double waterline_deg, double bow_length) {
  std::ostringstream obj;
  constexpr int n = 24;
  for (const double side : {1.0, -1.0})
    for (const double z : {-2.0, 1.0})
      for (int i = 0; i <= n; ++i) {
        const double y = half_beam * i / n;
        obj << "v " << -aft(y, waterline_deg, bow_length) + 2.0 * z << ' ' << side * y << ' ' << z << '\n';
      }
  for (int side = 0; side < 2; ++side)
    for (int i = 1; i <= n; ++i) {
      const int a = side * 2 * (n + 1) + i;
      obj << "f " << a << ' ' << a + 1 << ' ' << a + n + 2 << ' ' << a + n + 1 << '\n';
    }
  return obj.str();
}

std::string sample_lines_svg(const std::string& title, double stem_deg, double waterline_deg) {
  std::ostringstream svg;
  const double rise = 120.0 * std::tan(radians(stem_deg)), spread = 90.0 * std::tan(radians(waterline_deg));
  svg << "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 360\" "
         "role=\"img\" "
         "aria-labelledby=\"t\"><title id=\"t\">"
      << title << "</title><defs><clipPath id=\"c\"><rect width=\"640\" height=\"360\"/></clipPath></defs>"
      << "<g clip-path=\"url(#c)\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.2\">"
      << "<path d=\"M20 60H600L" << 600 - 120 << ' ' << 60 + rise << "L20 " << 60 + rise << "Z\"/>"
      << "<path d=\"M20 260H620C560 " << 260 - spread / 2 << " 500 " << 240 - spread << " 430 "
      << 240 - spread << "H20\"/>"
      << "<path stroke-dasharray=\"4 3\" d=\"M10 90H630M10 260H630\"/></g>"
      << "<text x=\"20\" y=\"40\" font-size=\"14\" fill=\"currentColor\">Profile, stem " << stem_deg
      << " deg</text></svg>\n";
  return svg.str();
}

void write_sample_picture(const std::string& path, int width_px, double advance, unsigned seed) {
  const Scene scene(advance, seed);
  const int height = width_px / 2;
  std::vector<Rgb> pixels;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width_px; ++i)
      pixels.push_back(scene.at(3.0 * i / width_px, 1.5 * (0.5 - static_cast<double>(j) / height)));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_px);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, pixels.data(), 0, nullptr))
    throw RuntimeError(path + ": " + image.message);
}

}  // namespace icebow
