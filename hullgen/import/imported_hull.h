// A hull somebody else drew: from a mesh file to a hull that ice can be broken with.
#pragma once

#include <string>

#include "hullgen/bow/bow.h"
#include "hullgen/import/hull_measurement.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/mesh_repair.h"

namespace icebow {

struct ImportedHull {
  std::string file;          // as it was named
  QuadMesh mesh;             // closed, outward, free of self-intersections; origin at the stem
  HullMeasurement measured;  // in the mesh's frame: P0 is the origin
  MeshRepairs repairs;       // that were needed
  double stem = 0.0;         //!< where the file has the stem, along its forward axis [m]
  double L = 0.0;            //!< length of the waterline, stem to its aft end [m]
  double B = 0.0;            //!< beam of the waterline [m]
  double T = 0.0;            //!< draught, to the mesh's lowest point [m]
  double D = 0.0;            //!< depth, the mesh's lowest to its highest point [m]
  double Lf = 0.0;           //!< stem to where the waterline first has 99.5 % of its beam [m]
};

// Reads, brings into the frame, mends (mesh_repair.h), checks with CGAL, finds the stem (the foremost point
// of the waterline on the centre plane becomes the origin) and measures. With `mirror` the file has one side
// of the hull, and its centre plane is the file's own. Panels without a patch of their own get one by where
// they lie and face. Throws InputError naming the file, what is wrong, where, and what to change.
ImportedHull import_hull(const std::string& file, const MeshFrame& frame, bool mirror);

// As the rest of the program takes a hull: no family, nothing requested, no margins.
Hull as_hull(const ImportedHull& imported);

}  // namespace icebow
