// The angles of a hull along its waterlines, and what ice class rules take from them.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// The tangent plane at one place of a waterline, port side, in the words of the rules.
struct StationAngles {
  double share = 0.0;         // of the bow's length aft of the stem, 0 to 1
  Vec3 at = Vec3::Zero();     //!< [m]
  double waterline = 0.0;     //!< alpha, against the centre plane [rad]
  double buttock = 0.0;       //!< gamma, against the horizontal [rad]
  double flare = 0.0;         //!< beta, section from the vertical [rad]
  double normal_flare = 0.0;  //!< beta', from the vertical in the plane of the normal [rad]
  double plate_slope = 0.0;   //!< psi, the plate's normal from the vertical: 90 deg - beta' [rad]
  double spread = 0.0;        //!< how much the normal turns with the neighbourhood asked [rad]
};

struct WaterlineAngles {
  double z = 0.0;           //!< [m]
  double bow_length = 0.0;  //!< stem to where the half-breadth is 99.5 % of the largest [m]
  std::vector<StationAngles> stations;
};

// Shares of the bow's length at which stations lie. 1/8, 3/8, 5/8 and 7/8 are the middles of four equal
// parts.
const std::vector<double>& station_shares();

// At the height z [m] of a closed hull about y = 0; the normals are those of the surface fitted to the mesh's
// points (surface_normal.h), but those on chords (chord_points.h). No stations where the height does not cut
// the hull on its centre plane.
WaterlineAngles angles_along_waterline(const QuadMesh& mesh, double z,
                                       const std::vector<int>& on_chords = {});

}  // namespace icebow
