// A small picture of a bow, cut from its mesh file: the design waterline from above.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace icebow {

// Port half of the design waterline z = 0 from the stem to the widest point [m]. From a Wavefront OBJ with
// quads or triangles in the hull frame (see QuadMesh). Empty where the file is missing or is no such hull.
std::vector<Vec3> read_waterline(const std::string& obj_path);

// Plan view, stem to the right, cut off `length` metres aft of it; `scale` pixels per metre.
struct BowOutline {
  std::string path;                  // the d of an SVG path; empty for no waterline
  double width = 0.0, height = 0.0;  //!< [px]
};
BowOutline bow_outline(const std::vector<Vec3>& waterline, double length, double scale);

}  // namespace icebow
