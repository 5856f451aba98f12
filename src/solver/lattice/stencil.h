// The bonds of a lattice particle: one list of offsets for each layer, with the constants of each offset.
//
// Source: Madenci and Oterkus 2014, ch. 4 (bond constants a, b, d) and ch. 10 (volume and surface
// corrections); see docs/theory.md, equations (3)-(9).
#pragma once

#include <array>
#include <vector>

#include "solver/lattice/lattice.h"
#include "solver/model/scenario.h"

namespace icebow {

// Constants of the ordinary state-based material on this lattice.
struct Material {
  double kappa = 0.0;             //!< bulk modulus [Pa]
  double mu = 0.0;                //!< shear modulus [Pa]
  double delta = 0.0;             //!< horizon [m]
  double a = 0.0;                 //!< [Pa]
  double b = 0.0;                 //!< [Pa/m^5]
  double d = 0.0;                 //!< [1/m^4]
  double s0 = 0.0;                // critical stretch; of ice with a tensile strength that strength over E
  double tensile_strength = 0.0;  //!< [Pa]; 0 = bonds break at s0

  // Normal stress on the plane across a bond, eq. (39): stretch and the mean of both ends' dilatations.
  double normal_stress(double stretch, double theta) const {
    return 2.0 * mu * stretch + (kappa - 2.0 / 3.0 * mu) * theta;
  }
};

Material make_material(const IceMaterial& ice, double dx, double horizon_ratio);

// Critical stretch of an ordinary state-based material from the fracture toughness, eq. (8):
// s0 = sqrt(G_c / ((3 mu + (3/4)^4 (kappa - 5 mu/3)) delta)), G_c = K_I^2 / E.
double critical_stretch(const IceMaterial& ice, double delta);

struct Offset {
  int di = 0, dj = 0, dk = 0;
  double length = 0.0;         //!< reference length of the bond [m]
  double volume_factor = 0.0;  // nu: part of the neighbour's volume inside the horizon
};

// Layer k sees the offsets with 0 <= k + dk < nz. Each bond is kept once, at its lower end: dj > 0, or dj = 0
// and dk > 0, or dj = dk = 0 and di > 0. "Slot" is the place of an offset in its layer's list of those; di is
// the outermost key, so that two updates of the same row of neighbours, one particle apart, never follow each
// other closely.
struct Stencil {
  std::vector<std::vector<Offset>> family;  // [k]: the whole family of a particle of layer k
  std::vector<std::vector<Offset>> half;    // [k][slot]: its bonds to higher ends
  std::vector<int> first_slot;              // slots of the layers below; last entry: slots of a column

  int slots(int k) const { return static_cast<int>(half[k].size()); }
  int column_slots() const { return first_slot.back(); }
};

Stencil make_stencil(int nz, double dx, double horizon);

// Where a particle is in the sheet, as far as its family can tell: distances to the edges, each cut at
// `reach`.
struct EdgeDistance {
  int x_lo, x_hi, y_lo, y_hi, k;
};

// Surface correction factors of a particle along x, y, z: what its incomplete family must be multiplied with
// so that a uniform stretch along that axis gives the dilatation and the distortional energy of the bulk.
struct SurfaceFactors {
  std::array<double, 3> dilatation, distortion;
};
SurfaceFactors surface_factors(const EdgeDistance& where, const Stencil& stencil, const Material& material,
                               double dx);

// Factor of a bond: both ends averaged, interpolated on the ellipsoid of its direction:
// G = (sum_c n_c^2 / g_c^2)^(-1/2), eq. (7).
double bond_factor(const std::array<double, 3>& end1, const std::array<double, 3>& end2, const Offset& offset,
                   double dx);

}  // namespace icebow
