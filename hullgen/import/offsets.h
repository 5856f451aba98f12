// The table of offsets of a hull: half-breadths by station and waterline, out of a mesh and into one.
#pragma once

#include <string>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Port side; both sides alike. Lengths in metres, x forward, z up.
struct Offsets {
  std::vector<double> z;                             // waterlines, upward
  std::vector<double> x;                             // stations, from fore to aft
  std::vector<double> fore_x, fore_y, aft_x, aft_y;  // ends of each waterline, and its half-breadth there
  std::vector<std::vector<double>> y;                // [station][waterline]; NaN beyond the waterline's ends
};

// Offsets of a closed hull about y = 0. Waterlines lie evenly from keel to top, the ends a ten-thousandth of
// the depth inside. Stations lie evenly from fore to aft, with twice as many in the foremost quarter.
Offsets offsets_of(const QuadMesh& mesh, int waterlines = 41, int stations = 41);

// Comma-separated: a head "x_m" and the heights, rows "fore end", "fore half-breadth", "aft end" and "aft
// half-breadth", then one row a station that begins with its x; "#" begins a comment.
std::string offsets_csv(const Offsets& offsets);

// Reads that. Rows of ends may be missing: a waterline then ends at its last stations, on the centre plane in
// front and with a transom aft. Throws InputError naming file and line.
Offsets read_offsets(const std::string& path);

// The port half as panels between neighbouring waterlines, with the lowest and the highest one closed: to be
// mirrored.
QuadMesh lofted_half(const Offsets& offsets);

}  // namespace icebow
