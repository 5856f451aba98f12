// What CGAL says of a quad mesh.
#pragma once

#include <string>

#include "geometry/quad_mesh.h"

namespace icebow {

struct MeshCheck {
  bool valid_polygon_mesh = false;
  std::string flaw;  // why it is none, in words with the place [m]
  bool closed = false;
  bool outward = false;              // bounds a volume with outward orientation
  bool self_intersecting = false;    // tested on the triangulated mesh
  int intersections = 0;             // pairs of triangles that cross
  Vec3 intersection = Vec3::Zero();  //!< where the first of them is [m]
  double max_warp = 0.0;  // largest distance of a quad's corner from its mean plane over its mean edge length
  double max_aspect = 0.0;      // largest ratio of a quad's longest to its shortest edge
  double max_bow_aspect = 0.0;  // the same among the patches bow and reamer, which break the ice
  int quads = 0, triangles = 0, points = 0;
  double volume = 0.0;  //!< [m^3]

  bool ok() const { return valid_polygon_mesh && closed && outward && !self_intersecting; }
  std::string reason() const;  // the first thing wrong, in words; empty where ok
};

// Never throws for a broken mesh: wrong indices, edges of three panels, panels turned over and points that
// are not finite are an invalid polygon mesh.
MeshCheck check_mesh(const QuadMesh& mesh);

}  // namespace icebow
