// A hull somebody else drew: from a mesh file to a hull that ice can be broken with.
#pragma once

#include <string>

#include "hullgen/bow/bow.h"
#include "hullgen/import/hull_measurement.h"
#include "hullgen/mesh/mesh_import.h"
#include "hullgen/mesh/mesh_repairs.h"

namespace icebow {

struct ImportedHull {
  std::string file;            // as it was named
  QuadMesh mesh;               // closed, outward, free of self-intersections; origin at the stem
  HullMeasurement measured;    // in the mesh's frame: P0 is the origin
  MeshRepairs repairs;         // that were needed
  std::vector<int> on_chords;  // points of the mesh that lie on no surface (chord_points.h)
  double stem = 0.0;           //!< where the file has the stem, along its forward axis [m]
  double L = 0.0;              //!< length of the waterline, stem to its aft end [m]
  double B = 0.0;              //!< beam of the waterline [m]
  double T = 0.0;              //!< draught, to the mesh's lowest point [m]
  double D = 0.0;              //!< depth, the mesh's lowest to its highest point [m]
  double Lf = 0.0;             //!< stem to where the waterline first has 99.5 % of its beam [m]
};

struct ImportChoice {
  bool mirror = false;  // the file has one side of the hull, and its centre plane is the file's own
  bool outer_surface =
      false;  // the file has an open boat with its plating: take its outside, closed by a deck
  ImportProgress progress;
};

// Reads, brings into the frame, mends (mesh_repair.h, import/mesh_solids.h), checks with CGAL, finds the stem
// (the foremost point of the waterline on the centre plane becomes the origin) and measures. What was done is
// in `repairs`, and there what may be wrong with the hull: sides that differ, angles no icebreaker has, a
// wrap instead of a mesh beyond mending. Panels without a patch of their own get one by where they lie and
// face. Throws InputError naming the file, what is wrong, where, and what to change: also for a waterline
// with a large hole, and for a block coefficient above 1. A hull whose angles cannot be read has NaN for
// them, and a warning.
ImportedHull import_hull(const std::string& file, const MeshFrame& frame, const ImportChoice& choice = {});

// The same of a mesh that is in the hull's frame already; `name` is for messages, `repairs` what was done
// before.
ImportedHull hull_of_mesh(QuadMesh mesh, const std::string& name, const ImportChoice& choice = {},
                          const MeshRepairs& repairs = {});

// As the rest of the program takes a hull: no family, nothing requested, no margins.
Hull as_hull(const ImportedHull& imported);

}  // namespace icebow
