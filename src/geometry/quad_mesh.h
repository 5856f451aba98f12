// A closed surface of quads: where hull generation and the ice solver meet.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace icebow {

// Which part of the ship a quad belongs to.
enum class Patch : std::uint8_t { bow, side, bottom, transom, deck, reamer, other };

// Points in metres. A quad lists its corners counter-clockwise seen from outside (outward normal by the
// right-hand rule); a triangle repeats its last corner (q[3] == q[2]). Hull frame: origin at the stem on the
// design waterline, x forward, y to port, z up, z = 0 at the design waterline.
struct QuadMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<Patch> patch;  // one per quad

  bool is_triangle(std::size_t quad) const { return quads[quad][2] == quads[quad][3]; }
};

struct Box {
  Vec3 lower, upper;
};

Box bounding_box(const QuadMesh& mesh);
// The mesh with every point multiplied by the factor (model scale = full scale / lambda).
QuadMesh scaled(const QuadMesh& mesh, double factor);
// Enclosed volume [m^3] by the divergence theorem; each quad is split along its diagonal 0-2.
double enclosed_volume(const QuadMesh& mesh);
// A corner of a quad that has no mirror image in the plane y = 0 among the quads, nothing where all have.
// Corners nearer to each other than the tolerance [m] count as one.
std::optional<Vec3> place_without_mirror_image(const QuadMesh& mesh, double tolerance);

}  // namespace icebow
