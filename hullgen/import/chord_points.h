// Points of a mesh that lie on a chord of the surface instead of on the surface.
#pragma once

#include <vector>

#include "geometry/mesh_slice.h"

namespace icebow {

// A point that was put into the middle of a panel's straight edge (T-junction) says nothing of the surface
// that the panels stand for: where the surface is straight the ends of the edge say as much, and where it is
// curved the point lies off it.
class ChordPoints {
 public:
  // The numbers of such points in the mesh.
  ChordPoints(const QuadMesh& mesh, const std::vector<int>& points);

  bool has(int point) const { return on_chord_[static_cast<std::size_t>(point)] != 0; }
  // Without the corners that are such points and in which the line goes straight on.
  Polyline without(const Polyline& line) const;

 private:
  bool at(const Vec3& p) const;

  std::vector<char> on_chord_;  // per point of the mesh
  std::vector<Vec3> sorted_;    // the points on chords by x
  double near_ = 0.0;           //!< [m]
};

// The numbers of the mesh's points that lie at the places.
std::vector<int> points_at(const QuadMesh& mesh, std::vector<Vec3> places);

}  // namespace icebow
