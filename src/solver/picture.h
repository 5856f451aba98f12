// Top view of the broken ice as a PNG (libpng), and ParaView snapshots.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/quad_mesh.h"

namespace icebow {

// The sheet's particles gathered on one rank, any order. Model scale, metres; x, y, z current positions.
struct IceCloud {
  std::vector<float> x, y, z;
  std::vector<float> ux, uy, uz;             // displacement
  std::vector<float> damage;                 // broken / initial bonds, 0..1
  std::vector<std::int32_t> piece;           // 0 = standing sheet, > 0 = floe number, -1 = crushed (small pieces)
  double dx = 0.0;                           //!< lattice spacing [m]
};

struct PictureFrame {
  double x_min, x_max, y_min, y_max;  //!< window of the sheet that is drawn [m]
  int width_px = 900;                 // the height follows
};

// Ice seen from above: standing sheet, floes by number in distinguishable tints, cracks dark, crushed ice, open water; the hull's
// waterline as an outline (hull in its own frame, its origin at (hull_x, 0)). Throws RuntimeError naming the file.
void write_top_view(const std::string& path, const IceCloud& ice, const QuadMesh& hull, double hull_x,
                    const PictureFrame& frame);

// One ParaView PolyData file with the particles as vertices (appended raw) and arrays displacement, damage, piece.
void write_ice_vtp(const std::string& path, const IceCloud& ice);
void write_hull_vtp(const std::string& path, const QuadMesh& hull, double hull_x);
// The collection file over (time, file name) pairs; rewritten atomically as a run goes on.
void write_pvd(const std::string& path, const std::vector<std::pair<double, std::string>>& steps);

}  // namespace icebow
