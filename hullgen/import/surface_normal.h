// The normal of the smooth surface that the panels of a mesh stand for, at one place.
#pragma once

#include <array>
#include <vector>

#include "geometry/quad_mesh.h"
#include "hullgen/import/chord_points.h"

namespace icebow {

struct SurfaceNormal {
  bool found = false;
  Vec3 normal = Vec3::Zero();  // outward, of unit length
  int points = 0;              // of the mesh, that were fitted
  double spread = 0.0;         //!< how much it turns with the neighbourhood that is asked [rad]
};

// Which part of the surface a normal is asked of.
struct Neighbourhood {
  Vec3 at = Vec3::Zero();        //!< where [m]; may lie beside the surface, in the extension of it
  Vec3 seed = Vec3::Zero();      //!< a place on the surface from which it is followed [m]
  double inboard = -1e300;       //!< points with a smaller y are not asked [m]
  double reach = 0.0;            //!< how far points may be [m]
  bool curvature_jumps = false;  // across y, at the place: P1 of many hulls
};

// Fits a quadratic height function over the plane that the surface faces most (x over y and z where it faces
// forward) to the mesh's points around the place, weighted by distance: of the nearest 40 down to 11 as many
// as it fits to 0.05 % of the neighbourhood's radius, or those it fits best. Points count that are reached
// from `seed` without crossing a knuckle: of the limits 25, 12, 6, 3 and 1.5 deg between panels the widest is
// taken that leaves 0.3 % or less. A seventh term is the change of curvature with height, or the jump of
// curvature across y where that is said. A flat panel with few points is its own plane. Mesh points lie on
// the true surface, unlike cuts through panels, and unlike points on chords, which are not asked.
class SurfaceNormals {
 public:
  // `on_chords`: numbers of the mesh's points on chords (chord_points.h).
  SurfaceNormals(const QuadMesh& mesh, const std::vector<int>& on_chords);
  SurfaceNormal at(const Neighbourhood& where) const;
  const ChordPoints& on_chords() const { return on_chords_; }

 private:
  const QuadMesh& mesh_;
  std::vector<std::array<int, 3>> facets_;
  ChordPoints on_chords_;
};

}  // namespace icebow
