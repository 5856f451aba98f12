#include "solver/output/picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/hull_section.h"
#include "solver/output/particle_tiles.h"
#include "solver/output/picture_canvas.h"

namespace icebow {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr Color sea{22, 61, 92}, standing{236, 242, 246}, crack{44, 54, 68}, crushed{146, 155, 163};
constexpr Color hull_fill{176, 60, 48}, hull_line{92, 20, 18};
// Light enough that cracks stay darker than any of them, in an order that keeps successive numbers apart.
constexpr Color floe_tints[] = {{173, 214, 235}, {240, 221, 178}, {188, 224, 196}, {214, 200, 236},
                                {243, 205, 199}, {164, 219, 214}, {226, 229, 170}, {186, 198, 238}};

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

Color ice_color(const IceCloud& ice, std::size_t i) {
  if (ice.piece[i] < 0) return crushed;
  const float dx = static_cast<float>(ice.dx);
  if (ice.piece[i] == 0) {
    // A sheet pressed down by one spacing is a shade darker.
    const float pressed = std::clamp(-ice.uz[i] / dx, -0.3f, 1.0f);
    return mix(mix(standing, {176, 198, 216}, 0.6f * std::max(0.0f, pressed)), crack,
               0.9f * smooth_step(0.15f, 0.45f, ice.damage[i]));
  }
  constexpr int tints = sizeof floe_tints / sizeof floe_tints[0];
  // A small floe is all edge: it must still stand out from the sea.
  return mix(floe_tints[ice.piece[i] % tints], crack, 0.45f * smooth_step(0.2f, 0.55f, ice.damage[i]));
}

// Light from the upper left, nothing changed on a level face.
Color lit(const Color& color, const Vec3f& u, const Vec3f& v) {
  Vec3f n = u.cross(v).stableNormalized();
  if (n.z() < 0.0f) n = -n;
  const Vec3f light = Vec3f(-0.45f, 0.45f, 0.77f);
  const float shade = std::clamp(0.75f + 0.25f * n.dot(light) / light.z(), 0.5f, 1.06f);
  return {color.r * shade, color.g * shade, color.b * shade};
}

// Upper side of the undisturbed sheet.
float upper_side(const IceCloud& ice) {
  float top = -std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < ice.z.size(); ++i)
    if (std::isfinite(ice.z[i] - ice.uz[i])) top = std::max(top, ice.z[i] - ice.uz[i]);
  return std::isfinite(top) ? top + 0.5f * static_cast<float>(ice.dx) : 0.0f;
}

// From a cube's centre to the one of two opposite sides that looks up.
Vec3f upwards(const Vec3f& edge) {
  return edge.z() < 0.0f ? -0.5f * edge : 0.5f * edge;
}

void draw_particle(Canvas& canvas, const IceCloud& ice, std::size_t i, const Tile& tile, float top) {
  const float dx = static_cast<float>(ice.dx);
  const Vec3f centre(ice.x[i], ice.y[i], ice.z[i]);
  if (!centre.allFinite()) return;
  if (ice.piece[i] < 0 && centre.z() > top + 4 * dx) return;  // spray of lone particles hides what is below
  // The deeper under water the bluer, from half a dozen spacings on.
  const float depth = std::max(0.0f, (top - centre.z()) / dx - 3.0f);
  const float blue = 0.72f * (1.0f - std::exp(-depth / 7.0f));
  const Color color = ice_color(ice, i);
  const auto face = [&](const Vec3f& at, const Vec3f& u, const Vec3f& v) {
    canvas.tile(at, u, v, mix(lit(color, u, v), sea, blue));
  };
  if (ice.piece[i] < 0) return face(centre, 0.7f * tile.x, 0.7f * tile.y);
  face(centre + upwards(tile.z), tile.x, tile.y);
  if (tile.z.head<2>().norm() < 0.25f * dx) return;
  // A tilted cube shows sides; a little lower, so that they do not show between the cubes of one face.
  const Vec3f lower(0, 0, -0.1f * dx);
  face(centre + upwards(tile.x) + lower, tile.y, tile.z);
  face(centre + upwards(tile.y) + lower, tile.z, tile.x);
}

std::vector<Segment> moved(std::vector<Segment> lines, double x) {
  for (auto& [a, b] : lines) a.x() += x, b.x() += x;
  return lines;
}

}  // namespace

void write_top_view(const std::string& path, const IceCloud& ice, const QuadMesh& hull, double hull_x,
                    const PictureFrame& frame) {
  Canvas canvas(frame.x_min, frame.x_max, frame.y_min, frame.y_max, frame.width_px, sea);
  const std::vector<Tile> tiles = particle_tiles(ice);
  const float top = upper_side(ice);
  for (std::size_t i = 0; i < tiles.size(); ++i) draw_particle(canvas, ice, i, tiles[i], top);

  const std::vector<Segment> waterline = moved(hull_section(hull, 0.0), hull_x);
  canvas.fill(waterline, hull_fill, 0.42f);
  canvas.stroke(moved(hull_section(hull, top), hull_x), 1.0, hull_line, 0.45f);
  canvas.stroke(waterline, 2.0, hull_line, 0.95f);
  draw_scale_bar(canvas);
  write_png(path, canvas.width(), canvas.height(), canvas.rgb());
}

}  // namespace icebow
