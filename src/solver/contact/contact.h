// The ice touches the hull: relocation, impulse, friction, and the reaction on the hull.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/hull_distance.h"
#include "geometry/quad_mesh.h"
#include "solver/contact/contact_energy.h"
#include "solver/ice/sheet.h"
#include "solver/model/exact_sum.h"
#include "solver/model/scenario.h"

namespace icebow {

// Force of the hull on one particle of ice by its depth in the hull, eq. (40) of docs/theory.md: plastic,
// with the crushing pressure on the particle's face. What one row of particles no longer bears, the row
// behind it bears, so that a wall feels the crushing pressure at every depth; the work of crushing is the
// pressure times the volume cut.
struct CrushingLaw {
  double strength = 0.0;   //!< crushing pressure times dx^2 [N]
  double stiffness = 0.0;  //!< of unloading and reloading [N/m]
  double dx = 0.0;         //!< [m]

  // Part of the spacing over which a particle's force rises and falls. With 3/4 the pressure on a wall of any
  // slope ripples by 3 % (standard deviation) at most; with 1/4 by 25 %.
  static constexpr double ramp = 0.75;

  // The most that the particle bears at a depth [N].
  double bearable(double depth) const;
  // Force at a depth above 0; `crushed` is the depth without force after what came before [m], and grows.
  double force(double depth, double& crushed) const;
  // The particle bears nothing any more.
  bool used_up(double crushed) const { return dx > 0.0 && crushed >= (1.0 + ramp) * dx; }
};

// Of the contact between one particle and the hull [N/m]; 0 for rules that stop a particle at once. It limits
// the time step: stability.h.
double contact_stiffness(const Scenario& scenario);

struct ContactSettings {
  ContactRule rule = ContactRule::relocation;
  double friction = 0.0;       // Coulomb coefficient
  double V = 0.0;              //!< hull speed along +x [m/s]
  double dt = 0.0;             //!< [s]
  double particle_mass = 0.0;  //!< [kg]
  double stiffness = 0.0;      //!< contact_stiffness() [N/m]
  CrushingLaw crushing;        // crushing rule only
};

// What contact does to one particle, eq. (17)-(19) and (40) of docs/theory.md.
struct ContactResponse {
  Vec3 push = Vec3::Zero();     // displacement added [m]
  Vec3 delta_v = Vec3::Zero();  // velocity added [m/s]
};
// Crushing rule: `crushed` is how deep the hull has crushed the particle [m], and grows.
ContactResponse respond(const ContactSettings& settings, const ClosestPoint& hit, const Vec3& velocity,
                        double& crushed);

class HullContact {
 public:
  HullContact(const QuadMesh& hull, const Box& region, const ContactSettings& settings);

  // Treats every particle of the owned columns [jl0, jl1) inside the hull, whose origin is at (hull_x, 0, 0);
  // adds the impulse of the ice on the hull about that origin, and every strike to `ledger`. Returns the
  // number of particles in contact.
  int apply(IceSheet& sheet, double hull_x, int jl0, int jl1, ExactImpulse& impulse, ContactLedger& ledger);
  // From now on the impulse on each quad of the hull is kept as well.
  void watch_faces() { face_impulse_.assign(3 * faces_.size(), 0); }
  // x, y, z of each quad in turn, in whole multiples of ExactImpulse::linear(), since the last call; empty
  // where nobody watches.
  std::vector<std::int64_t> take_face_impulse();
  // The ice has been moved by something else than the drift, or renumbered: nothing is known of it any more.
  void look_again() {
    blocks_.clear();
    near_.clear();
  }

 private:
  struct Plane {
    Vec3 point, normal;
  };
  // What is known of a block of a row: how far its particles have moved in the hull's frame since they were
  // looked at, and how far they may at most until one of them must be looked at again [m]; and the place in
  // near_, where one of them may be inside or has been.
  struct Watch {
    float moved = 0.0F, least = 0.0F;
    std::int32_t near = -1;
  };
  // A step's part of a pass.
  struct Pass {
    IceSheet& sheet;
    double hull_x;
    ExactImpulse& impulse;
    ContactLedger& ledger;
  };
  ClosestPoint in_contact(const ClosestPoint& hit, const Vec3& position, int& face) const;
  template <class Real>
  void approach(const IceSheet& sheet, int jl, int k);
  int look_at(const Pass& pass, int jl, int k, int b);
  bool touch(const Pass& pass, std::size_t p, const Vec3& position, double z, HullDistance::Known& known);

  std::vector<Plane> faces_;                // of the hull's quads
  std::vector<std::int64_t> face_impulse_;  // of take_face_impulse()
  HullDistance distance_;
  ContactSettings settings_;
  std::vector<Watch> blocks_;  // [column][layer][block]
  // Of each of their particles: how far it may move until it may be inside [m], 0 of one that may be.
  std::vector<float> rest_;
  // What the search for the nearest triangle has found, of blocks near the hull.
  std::vector<std::array<HullDistance::Known, block>> near_;
};

}  // namespace icebow
