// Everything one icebreaking run needs besides the hull. SI, at the scale that is simulated (the model's).
#pragma once

#include <string>

namespace icebow {

struct IceMaterial {
  double h = 0.0;    //!< thickness [m]
  double rho = 0.0;  //!< density [kg/m^3]
  double E = 0.0;    //!< elastic modulus [Pa]
  double nu = 0.0;   //!< Poisson's ratio
  double s0 = 0.0;   //!< critical stretch; 0 = from K_I
  double K_I = 0.0;  //!< fracture toughness [Pa m^0.5]; used where s0 = 0
  // Above 0 a bond breaks where the normal stress on the plane across it is above this (Rankine), instead of
  // at a critical stretch [Pa]
  double tensile_strength = 0.0;
  double crushing_pressure = 0.0;  //!< of the ice against the hull, crushing rule only [Pa]
};

enum class WaterInertia {
  layer,  // of a layer of water that goes with each column, Water::added_mass
  plane   // of all water under the sheet; for ice that has left the sheet's plane, the layer's
};

struct Water {
  double rho = 1000.0;               //!< density [kg/m^3]
  bool buoyancy_and_gravity = true;  // false: as in the paper, an ice sheet held by its fixed edges alone
  WaterInertia inertia = WaterInertia::layer;
  // Of ice that accelerates across its plane: so deep a layer of water goes with each of its columns; 0 =
  // none [m]
  double added_mass = 0.0;
  double drag = 0.0;  // coefficient of a plate's drag across its plane, in deep water; 0 = none
};

enum class FixedEdges { none, sides, sides_and_far };  // sides = port and starboard; far = ahead of the ship

struct Sheet {
  double length = 0.0;  //!< along the ship's course [m]
  double width = 0.0;   //!< across it, centred on the ship [m]
  FixedEdges fixed = FixedEdges::sides;
  // Above 0: `length` is that of a window that moves with the ship, its far edge held. Fresh ice is laid so
  // that this much lies ahead of the stem, and as much is dropped astern [m]
  double window_ahead = 0.0;
  // Above 0: the ice this near to the sheet's side and far edges is damped, so that waves that run out to
  // them do not come back [m]
  double absorbing = 0.0;
  // Only the port half is simulated, the starboard half being its mirror image in the plane y = 0.
  bool half_model = false;
};

enum class ContactRule {
  relocation,  // to the surface, approaching normal velocity removed, Coulomb friction (docs/theory.md)
  paper,       // velocity from the relocation itself, depth capped
  penalty,     // spring of stiffness E dx
  crushing     // rigid up to the crushing pressure; ice a spacing deep is crushed (docs/theory.md)
};

enum class Precision { fp32, fp64 };  // of the particles' fields; sums over the sheet are exact in both

struct Numerics {
  double dx = 0.0;             //!< lattice spacing [m]
  double horizon_ratio = 3.0;  //!< horizon / dx
  double dt = 0.0;             //!< time step [s]; 0 = dt_fraction of the stability limit
  double dt_fraction = 0.8;
  // Where nearest neighbours' displacements differ by at most this part of the spacing along each axis, bonds
  // follow the linearised law; 0 = nowhere.
  double linear_below = 1e-3;
  bool surface_correction = true;
  Precision precision = Precision::fp32;
  ContactRule contact = ContactRule::relocation;
  bool floe_contact = false;   // pieces of ice push back what they meet
  double floe_friction = 0.0;  //!< Coulomb coefficient between pieces of ice; with floe_contact
  int ranks_along_x = 0;       // MPI ranks along the ship's course; 0 = the smallest halo decides
  double friction = 0.0;       //!< hull-ice Coulomb coefficient
};

struct Scenario {
  IceMaterial ice;
  Water water;
  Sheet sheet;
  Numerics numerics;
  double V = 0.0;            //!< ship speed along +x [m/s]
  double advance = 0.0;      //!< distance from first touch to the end of the run [m]
  double steady_from = 0.0;  //!< metrics use the record from this advance on [m]
  // The run ends early once the mean load's 95 % interval has a half width of at most this part of it; 0 =
  // never.
  double stop_when_ci95_below = 0.0;
};

}  // namespace icebow
