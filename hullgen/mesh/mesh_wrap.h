// The wrap that is left where nothing else helps (CGAL).
#pragma once

#include "geometry/quad_mesh.h"

namespace icebow {

// How a wrap differs from what it wraps.
struct Wrapping {
  double fineness = 0.0;        //!< the smallest feature it enters [m]
  double volume = 0.0;          //!< of the wrap [m^3]
  double farthest_point = 0.0;  //!< of the wrap from the mesh [m]
};
// A closed surface around the mesh that needs nothing of it but that its gaps are narrower than `fineness`
// [m] (CGAL's alpha wrap). Its points are moved onto the mesh where that does not make it cross itself.
QuadMesh wrapped(const QuadMesh& mesh, double fineness, Wrapping& wrapping);

}  // namespace icebow
