#include "cycle/strips.h"

#include <algorithm>
#include <cmath>

namespace icebow::cycle {
namespace {

constexpr int samples = 2001;  // across the hull, to find its waterline's length
constexpr int heights = 5;
constexpr double steepest = 20.0;  // a corner of the waterline, like that of a box, is not to take all strips

double foremost(const FrontMap& map, int column) {
  double x = FrontMap::none;
  for (int row = 0; row < map.rows(); ++row) x = std::max(x, map.x(column, row));
  return x;
}

double largest_half_beam(const QuadMesh& hull) {
  double widest = 0.0;
  for (const Vec3& p : hull.points) widest = std::max(widest, std::abs(p.y()));
  return widest;
}

std::vector<double> sample_ys(double widest) {
  std::vector<double> ys(samples);
  for (int i = 0; i < samples; ++i)
    ys[static_cast<std::size_t>(i)] = widest * ((i + 0.5) / samples * 2.0 - 1.0);
  return ys;
}

// The steeper side counts, so that strips are alike on either side.
double slope(const std::vector<double>& x, std::size_t i, double dy) {
  double steep = 0.0;
  for (std::size_t j : {i, x.size() - 1 - i}) {
    if (j == 0 || x[j] == FrontMap::none || x[j - 1] == FrontMap::none) continue;
    steep = std::max(steep, std::abs(x[j] - x[j - 1]) / dy);
  }
  return std::min(steep, steepest);
}

// Strip borders from the centre plane out to the half-beam.
std::vector<double> borders(const std::vector<double>& x, double widest, double half_beam, double raster) {
  const double dy = 2.0 * widest / samples;
  std::vector<double> edge = {0.0};
  double along = 0.0;
  for (std::size_t i = samples / 2 + 1; i < x.size(); ++i) {
    const double y = widest * ((static_cast<double>(i) + 0.5) / samples * 2.0 - 1.0);
    if (y >= half_beam - 0.25 * dy) break;
    along += dy * std::sqrt(1.0 + std::pow(slope(x, i, dy), 2));
    if (along < raster) continue;
    edge.push_back(y);
    along = 0.0;
  }
  if (half_beam - edge.back() < 0.25 * dy && edge.size() > 1) edge.pop_back();
  edge.push_back(half_beam);
  return edge;
}

void measure(Strips& strips, const std::vector<double>& ys, const std::vector<double>& x) {
  double first = FrontMap::none, last = -FrontMap::none;
  const double dy = ys[1] - ys[0];
  for (std::size_t i = 0; i < ys.size(); ++i) {
    if (x[i] == FrontMap::none) continue;
    strips.half_beam = std::max(strips.half_beam, std::abs(ys[i]) + 0.5 * dy);
    first = std::max(first, x[i]), last = std::min(last, x[i]);
  }
  if (strips.half_beam > 0.0) strips.length = first - last;
}

}  // namespace

Strips make_strips(const QuadMesh& hull, double z_lower, double z_upper, double raster, double margin,
                   bool port_only) {
  Strips strips;
  const double widest = largest_half_beam(hull);
  if (!(widest > 0.0)) return strips;
  const FrontMap map(hull, sample_ys(widest), z_lower, (z_upper - z_lower) / (heights - 1), heights);
  std::vector<double> x(samples), ys(samples);
  for (int i = 0; i < samples; ++i)
    x[static_cast<std::size_t>(i)] = foremost(map, i), ys[static_cast<std::size_t>(i)] = map.y(i);
  measure(strips, ys, x);
  if (strips.half_beam == 0.0) return strips;
  std::vector<double> edge = borders(x, widest, strips.half_beam, raster);
  const int beside = static_cast<int>(std::ceil(margin / raster));
  for (int i = 1; i <= beside; ++i) edge.push_back(strips.half_beam + i * raster);
  for (std::size_t i = edge.size() - 1; i-- > 0 && !port_only;) {
    strips.y.push_back(-0.5 * (edge[i] + edge[i + 1]));
    strips.width.push_back(edge[i + 1] - edge[i]);
  }
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    strips.y.push_back(0.5 * (edge[i] + edge[i + 1]));
    strips.width.push_back(edge[i + 1] - edge[i]);
  }
  return strips;
}

HullFront::HullFront(const QuadMesh& hull, const Strips& strips, const Ice& ice, double reach)
    : bottom_row(static_cast<int>(std::ceil(reach * layers / ice.h)) + 1),
      map(hull, strips.y, ice.bottom() - bottom_row * ice.h / layers, ice.h / layers,
          layers + 1 + 2 * bottom_row),
      foremost(strips.y.size()) {
  for (int i = 0; i < strips.count(); ++i)
    foremost[static_cast<std::size_t>(i)] = icebow::cycle::foremost(map, i);
}

}  // namespace icebow::cycle
