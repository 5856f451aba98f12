// The hull of a bow as smooth surfaces, without a mesh: what CAD programs take.
#pragma once

#include <vector>

#include "hullgen/bow/bow.h"
#include "hullgen/cad/spline_surface.h"

namespace icebow {

// A flat face inside a closed ring of curves that meet end to end, in order; a curve may run either way.
struct FlatFace {
  std::vector<SplineCurve> ring;
};

// Faces of a closed hull in metres, hull frame of geometry/quad_mesh.h. Two faces that meet have the same
// curve there. Every smooth strip of the bow between creases (stem, chine, edge of the side) is one patch, on
// either side: bow from the stem outwards; then the reamer's step, where there is one, and side with bilge;
// then the skeg, where there is one, with the bottom's strip behind it.
struct HullSurfaces {
  std::vector<SplineSurface> port;  // without the mirror images to starboard
  std::vector<FlatFace> flat;       // bottom (its two sides beside a skeg), deck, transom
};

// Needs a feasible bow. The patches are the surface (8) of docs/bows.md to round-off wherever that is made of
// polynomials, which takes in the ice belt up to the shoulder's fairing; in the fairing and the bilge they
// are within 1e-6 of the beam.
HullSurfaces hull_surfaces(const BowParameters& bow);

}  // namespace icebow
