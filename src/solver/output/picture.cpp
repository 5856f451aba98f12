#include "solver/output/picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/hull_section.h"
#include "solver/output/particle_tiles.h"
#include "solver/output/picture_canvas.h"
#include "solver/output/picture_caption.h"
#include "solver/output/picture_text.h"
#include "solver/output/png_file.h"

namespace icebow {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr Color sea{22, 61, 92}, air{226, 234, 238}, standing{236, 242, 246}, crack{44, 54, 68},
    crushed{146, 155, 163};
// By CrackKind; across the ray, so in bending, as dark as a crack of no known kind.
constexpr Color crack_tints[crack_kinds] = {{124, 58, 168}, {30, 36, 48},  {208, 44, 120},
                                            {122, 104, 92}, {0, 118, 112}, {168, 172, 178}};
constexpr Color channel_line{245, 158, 11};
constexpr Color hull_fill{176, 60, 48}, hull_line{92, 20, 18};
// Light enough that cracks stay darker than any of them, in an order that keeps successive numbers apart.
constexpr Color floe_tints[] = {{173, 214, 235}, {240, 221, 178}, {188, 224, 196}, {214, 200, 236},
                                {243, 205, 199}, {164, 219, 214}, {226, 229, 170}, {186, 198, 238}};

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

Color crack_color(const IceCloud& ice, std::size_t i) {
  return ice.crack.empty() || ice.crack[i] == 0 ? crack : crack_tints[ice.crack[i] - 1];
}

Color ice_color(const IceCloud& ice, std::size_t i) {
  if (ice.piece[i] < 0) return crushed;
  const float dx = static_cast<float>(ice.dx);
  if (ice.piece[i] == 0) {
    // A sheet pressed down by one spacing is a shade darker.
    const float pressed = std::clamp(-ice.uz[i] / dx, -0.3f, 1.0f);
    return mix(mix(standing, {176, 198, 216}, 0.6f * std::max(0.0f, pressed)), crack_color(ice, i),
               0.9f * smooth_step(0.15f, 0.45f, ice.damage[i]));
  }
  constexpr int tints = sizeof floe_tints / sizeof floe_tints[0];
  // A small floe is all edge: it must still stand out from the sea.
  const bool known = !ice.crack.empty() && ice.crack[i] > 0;
  return mix(floe_tints[ice.piece[i] % tints], crack_color(ice, i),
             (known ? 0.65f : 0.45f) * smooth_step(0.2f, 0.55f, ice.damage[i]));
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

// Where the section stands on the canvas: its foot [px] and the heights it shows.
struct SectionPanel {
  double foot, low, high;  //!< [px], z [m], z [m]
};

void draw_section_ice(Canvas& canvas, const IceCloud& ice, const std::vector<Tile>& tiles,
                      const SectionPanel& panel, double y_of_zero) {
  const float dx = static_cast<float>(ice.dx);
  const auto turned = [](const Vec3f& edge) { return Vec3f(edge.x(), edge.z(), 0.0f); };
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const float across = ice.y[i] - ice.uy[i];  // before it moved
    const bool in_plane = std::abs(across) < dx && ice.z[i] > panel.low && ice.z[i] < panel.high;
    if (!in_plane || !std::isfinite(ice.x[i])) continue;
    const float over_all = 1e6f - std::abs(ice.y[i]);  // of what the top view has drawn there
    const Vec3f centre(ice.x[i], static_cast<float>(y_of_zero) + ice.z[i], over_all);
    const float size = ice.piece[i] < 0 ? 0.7f : 1.0f;
    canvas.tile(centre, size * turned(tiles[i].x), size * turned(tiles[i].z), ice_color(ice, i));
  }
}

// Where the plane y = 0 cuts the hull, in x and z, moved.
std::vector<Segment> centre_section(QuadMesh hull, const Vec2& by) {
  for (Vec3& point : hull.points) std::swap(point.y(), point.z());
  std::vector<Segment> lines = hull_section(hull, 0.0);
  for (auto& [a, b] : lines) a += by, b += by;
  return lines;
}

// The plane y = 0 from starboard: ice, hull, sea and air.
void draw_section(Canvas& canvas, const IceCloud& ice, const std::vector<Tile>& tiles, const QuadMesh& hull,
                  double hull_x, const SectionPanel& panel, double canvas_y_min) {
  const double per_metre = 1.0 / canvas.metres_per_pixel();
  const double sea_level = panel.foot - panel.low * per_metre;
  const double top = panel.foot + (panel.high - panel.low) * per_metre;
  const double y_of_zero = canvas_y_min + sea_level * canvas.metres_per_pixel();
  canvas.rectangle(0.0, panel.foot, canvas.width(), sea_level, sea);
  canvas.rectangle(0.0, sea_level, canvas.width(), top, air);
  draw_section_ice(canvas, ice, tiles, panel, y_of_zero);
  const std::vector<Segment> outline = centre_section(hull, Vec2(hull_x, y_of_zero));
  canvas.fill(outline, hull_fill, 0.42f);
  canvas.stroke(outline, 2.0, hull_line, 0.95f);
  canvas.rectangle(0.0, top - 1.0, canvas.width(), top, hull_line);
  const double dot = letter_dot(canvas.width());
  const std::string words = "section through the bow";
  draw_text(canvas, words, canvas.width() - text_width(words, dot) - 7.0 * dot, top - 12.0 * dot, dot,
            {22, 34, 48});
}

std::vector<LegendEntry> crack_legend(const IceCloud& ice) {
  if (ice.crack.empty()) return {{crack, "cracks"}};
  static const char* const words[crack_kinds] = {"radial crack",          "crack across, in bending",
                                                 "splitting crack",       "crushed at the hull",
                                                 "broken again under it", "held edge"};
  // The held edge is the sheet's doing and is seen in a few pictures.
  std::vector<LegendEntry> entries;
  for (int kind = 0; kind < crack_kinds; ++kind)
    if (CrackKind(kind) != CrackKind::held_edge) entries.push_back({crack_tints[kind], words[kind]});
  return entries;
}

std::vector<LegendEntry> legend(const IceCloud& ice, const PictureFrame& frame) {
  if (frame.title.empty()) return {};
  std::vector<LegendEntry> entries = {{standing, "standing ice"}, {floe_tints[0], "floes, a tint each"}};
  for (const LegendEntry& entry : crack_legend(ice)) entries.push_back(entry);
  entries.push_back({crushed, ice.crack.empty() ? "crushed ice" : "small pieces"});
  entries.push_back({sea, "open water"});
  if (!ice.crack.empty()) entries.push_back({channel_line, "edge of the channel"});
  entries.push_back({hull_fill, "hull at the waterline"});
  return entries;
}

}  // namespace

void write_top_view(const std::string& path, const IceCloud& ice, const QuadMesh& hull, double hull_x,
                    const PictureFrame& frame) {
  const std::vector<LegendEntry> entries = legend(ice, frame);
  const double metres_per_pixel = (frame.x_max - frame.x_min) / frame.width_px;
  const double foot = legend_height(entries, frame.width_px),
               head = title_height(frame.title, frame.width_px);
  if (!(frame.y_max > frame.y_min)) throw std::invalid_argument("a picture needs a window and a width");
  const Box box = bounding_box(hull);
  const double margin = 0.08 * (box.upper.z() - box.lower.z());
  const SectionPanel panel{foot, box.lower.z() - margin, box.upper.z() + margin};
  const double under = frame.section ? foot + std::round((panel.high - panel.low) / metres_per_pixel) : foot;
  const double y_min = frame.y_min - under * metres_per_pixel;
  Canvas canvas(frame.x_min, frame.x_max, y_min, frame.y_max + head * metres_per_pixel, frame.width_px, sea);
  const std::vector<Tile> tiles = particle_tiles(ice);
  const float top = upper_side(ice);
  for (std::size_t i = 0; i < tiles.size(); ++i) draw_particle(canvas, ice, i, tiles[i], top);

  const std::vector<Segment> waterline = moved(hull_section(hull, 0.0), hull_x);
  canvas.stroke(frame.channel, 1.6, channel_line, 0.9f);
  canvas.fill(waterline, hull_fill, 0.42f);
  canvas.stroke(moved(hull_section(hull, top), hull_x), 1.0, hull_line, 0.45f);
  canvas.stroke(waterline, 2.0, hull_line, 0.95f);
  if (frame.section) draw_section(canvas, ice, tiles, hull, hull_x, panel, y_min);
  draw_title(canvas, frame.title);
  draw_legend(canvas, entries);
  draw_scale_bar(canvas, frame.lambda, under);
  write_png(path, canvas.raster());
}

}  // namespace icebow
