// Panels with any number of corners, as mesh files have them.
#pragma once

#include <string>
#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// The corners of all polygons stand in one row, so that a million panels are a handful of allocations.
struct PolygonMesh {
  std::vector<Vec3> points;
  std::vector<int> corners;
  std::vector<std::size_t> ends;   // one per polygon: where its corners end in the row
  std::vector<Patch> patch;        // one per polygon
  std::vector<std::string> notes;  // what the file said wrongly and the reader understood, in words

  std::size_t size() const { return ends.size(); }
  std::size_t begin_of(std::size_t polygon) const { return polygon == 0 ? 0 : ends[polygon - 1]; }
  std::vector<int> polygon(std::size_t k) const {
    return {corners.begin() + static_cast<std::ptrdiff_t>(begin_of(k)),
            corners.begin() + static_cast<std::ptrdiff_t>(ends[k])};
  }
  // Closes the polygon whose corners were appended to the row since the last one.
  void close_polygon(Patch of) {
    ends.push_back(corners.size());
    patch.push_back(of);
  }
};

}  // namespace icebow
