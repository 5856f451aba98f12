// The ice touches the hull: relocation, impulse, friction, and the reaction on the hull.
#pragma once

#include "base/quad_mesh.h"
#include "solver/contact_energy.h"
#include "solver/exact_sum.h"
#include "solver/hull_distance.h"
#include "solver/scenario.h"
#include "solver/sheet.h"

namespace icebow {

struct ContactSettings {
  ContactRule rule = ContactRule::relocation;
  double friction = 0.0;           // Coulomb coefficient
  double V = 0.0;                  //!< hull speed along +x [m/s]
  double dt = 0.0;                 //!< [s]
  double particle_mass = 0.0;      //!< [kg]
  double penalty_stiffness = 0.0;  //!< [N/m], penalty rule only
  double crushing_force = 0.0;     //!< of one particle [N], crushing rule only
  double crushing_depth = 0.0;     //!< at which it is crushed [m], likewise
};

// What contact does to one particle, eq. (17)-(19) and (40) of docs/theory.md.
struct ContactResponse {
  Vec3 push = Vec3::Zero();     // displacement added [m]
  Vec3 delta_v = Vec3::Zero();  // velocity added [m/s]
};
ContactResponse respond(const ContactSettings& settings, const ClosestPoint& hit, const Vec3& velocity);

class HullContact {
 public:
  HullContact(const QuadMesh& hull, const Box& region, const ContactSettings& settings);

  // Treats every particle of the owned columns [jl0, jl1) inside the hull, whose origin is at (hull_x, 0, 0);
  // adds the impulse of the ice on the hull about that origin, and every strike to `ledger`. Returns the
  // number of particles in contact.
  int apply(IceSheet& sheet, double hull_x, int jl0, int jl1, ExactImpulse& impulse,
            ContactLedger& ledger) const;

 private:
  void strengthen(IceSheet& sheet, std::size_t p, double depth) const;

  HullDistance distance_;
  ContactSettings settings_;
};

}  // namespace icebow
