// The lines of a hull as a DXF drawing (AutoCAD R12 text, which every CAD program reads).
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

// Polylines in space, in metres in the hull's frame, on the layers PROFILE, WATERLINES, BUTTOCKS, STATIONS
// and DWL: 12 waterlines from keel to top, 4 buttocks a side at equal parts of the half-beam, 21 stations.
std::string lines_dxf(const QuadMesh& mesh);

}  // namespace icebow
