// Rows of vertices of the bow patch: the design waterline and buttocks, as polylines of (coordinate along,
// s).
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

struct RowPoint {
  double along, s;  //!< y or z, and metres aft of the stem [m]
};
using Row = std::vector<RowPoint>;

Row waterline_row(const QuadMesh& mesh);  // port side, from the stem out
Row buttock_row(const QuadMesh& mesh,
                double y);  // from the keel up; where the side is rounded, columns leave y

}  // namespace icebow
