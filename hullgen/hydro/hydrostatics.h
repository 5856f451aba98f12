// Hydrostatics of a closed hull at any draught and trim: what is under water, where its centres lie, and how
// stiff the waterplane is. Definitions are those of Principles of Naval Architecture [Lewis1988].
//
// Exact for the mesh: each quad is split as everywhere (geometry/triangles.h), each triangle cut by the water
// surface, and the integrals taken over the wetted triangles by the divergence theorem with fields that
// vanish on the water surface, so the cut is never meshed.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Where the water surface is, in the frame of the hull: z = level + (x_level - x) tan(trim).
struct Flotation {
  double level = 0.0;    //!< z of the surface at x_level [m]
  double x_level = 0.0;  //!< [m]
  double trim = 0.0;     //!< [rad] positive by the stern, within -pi/2 to pi/2
};

// Points are in the frame of the hull; heights and drafts count along its z from the keel, the mesh's lowest
// point. Areas and second moments are those of the water surface, which trim makes oblique to the hull.
struct Hydrostatics {
  double volume = 0.0;                           //!< [m^3]
  double displacement = 0.0;                     //!< volume times density [kg]
  Vec3 buoyancy = Vec3::Zero();                  //!< centre of buoyancy: LCB, TCB and height [m]
  double KB = 0.0;                               //!< [m]
  double waterplane_area = 0.0;                  //!< [m^2]
  Vec3 flotation = Vec3::Zero();                 //!< centroid of the waterplane: LCF is its x [m]
  double I_T = 0.0;                              //!< second moment about the centroid's long axis [m^4]
  double I_L = 0.0;                              //!< and about its transverse axis [m^4]
  double wetted_area = 0.0;                      //!< [m^2]
  double length = 0.0, beam = 0.0, draft = 0.0;  //!< of the waterplane; draft at x_level [m]
  double fore_end = 0.0, aft_end = 0.0;          //!< x of the ends of the waterplane [m]
  double block_coefficient = 0.0;                // volume / (length beam draft cos(trim)): 1 for a box
  double waterplane_coefficient = 0.0;           // waterplane_area / (length beam)
  double BM_T = 0.0, BM_L = 0.0;                 //!< I_T, I_L over volume [m]
  double KM_T = 0.0;                             //!< height of the transverse metacentre [m]
};

// Closed meshes with outward normals only, not checked. Throws InputError, with the range of levels, where
// the surface does not cut the hull.
Hydrostatics hydrostatics(const QuadMesh& mesh, const Flotation& at, double water_density);

// Volume under the level surface z = level [m^3]; 0 where that passes below the hull.
double displaced_volume(const QuadMesh& mesh, double level);
// Area of the section at x under the level surface [m^2]; 0 where there is none.
double immersed_section(const QuadMesh& mesh, double level, double x);

struct SectionArea {
  double x;     //!< [m]
  double area;  //!< of the immersed section, perpendicular to x [m^2]
};

// Evenly spaced from the aft end of the immersed hull to its fore end; at the ends the limits from inside, so
// an immersed transom shows.
std::vector<SectionArea> sectional_areas(const QuadMesh& mesh, const Flotation& at, int stations);

}  // namespace icebow
