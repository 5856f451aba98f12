#include "solver/contact/floe_contact.h"

#include <algorithm>
#include <cmath>

namespace icebow {
namespace {

// Of E dx, the stiffness of a cube of ice between two others: soft enough that what a contact stores is small
// beside what it takes, stiff enough that ice under its own crushing pressure overlaps by a fifth of a
// spacing.
constexpr double softness = 0.01;
// Of the acoustic impedance of a particle's face. Two bodies that meet press each other with half of it times
// the speed at which they meet, until the wave is back from their ends; less keeps a particle with several
// contacts within the lattice's time step.
constexpr double damping_share = 0.25;
// Of that damping: what holds pieces that slide so slowly that they creep rather than slip. As small, for the
// time step.
constexpr double creep_share = 0.5;

// How far the hull has moved a particle.
Vec3 push_at(std::size_t p, const std::vector<HullStrike>& strikes) {
  const auto at = std::lower_bound(strikes.begin(), strikes.end(), p,
                                   [](const HullStrike& s, std::size_t place) { return s.p < place; });
  return at != strikes.end() && at->p == p ? at->push : Vec3(Vec3::Zero());
}

}  // namespace

Vec3 FloeContactLaw::force(const Vec3& away, const Vec3& velocity) const {
  const double r = away.norm(), overlap = distance - r;
  if (overlap <= 0.0 || r == 0.0) return Vec3::Zero();
  const Vec3 n = away / r;
  const double approach = velocity.dot(n);
  const double pressed = std::clamp(stiffness * overlap - damping * approach, 0.0, strongest);
  const Vec3 sliding = velocity - approach * n;
  const double speed = sliding.norm();
  if (friction == 0.0 || speed == 0.0) return -pressed * n;
  return -pressed * n + std::min(friction * pressed / speed, creep_share * damping) * sliding;
}

FloeContactLaw floe_contact_law(const Scenario& s, const Material& material) {
  const double dx = s.numerics.dx;
  FloeContactLaw law;
  law.distance = dx;
  law.stiffness = softness * s.ice.E * dx;
  law.damping = damping_share * std::sqrt(s.ice.E * s.ice.rho) * dx * dx;
  // Ice whose crushing pressure is not known bears what its bonds do.
  const double pressure = s.ice.crushing_pressure > 0.0 ? s.ice.crushing_pressure : s.ice.E * material.s0;
  law.strongest = pressure * dx * dx;
  law.friction = s.numerics.floe_friction;
  return law;
}

FloeContact::FloeContact(const Communicator& comm, const Scenario& s, const Material& material,
                         const EnergyModel& model)
    : acts_(s.numerics.floe_contact),
      law_(floe_contact_law(s, material)),
      model_(model),
      pairs_(comm, 1.25 * law_.distance) {}

void FloeContact::find_pairs(const IceSheet& sheet) {
  if (acts_) pairs_.find(sheet);
}

FloeWork FloeContact::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  pairs_.refresh(sheet);
  FloeWork work;
  for (const ContactPairs::Of& of : pairs_.all()) {
    const ContactPairs::Particle& own = pairs_.particle(of.particle);
    Vec3 force = Vec3::Zero();
    for (int n = of.begin; n < of.end; ++n) {
      const ContactPairs::Particle other = pairs_.partner(n);
      const Vec3 away = other.position - own.position;
      if (away.squaredNorm() >= law_.distance * law_.distance) continue;
      force += law_.force(away, other.velocity - own.velocity);
    }
    if (force == Vec3::Zero()) continue;
    const Vec3 by_contact = force / model_.mass;
    Vec3 acceleration;
    for (int c = 0; c < 3; ++c) {
      acceleration[c] = sheet.acceleration[c][of.address] + by_contact[c];
      sheet.acceleration[c][of.address] = acceleration[c];
    }
    acceleration.z() += model_.weight_and_lift(own.position.z());
    const Vec3 mean_velocity = own.velocity + 0.5 * model_.dt * acceleration;
    const std::int64_t by_hull = -model_.quanta(force.dot(push_at(of.address, strikes)));
    work.by_hull += by_hull;
    work.taken += by_hull - model_.quanta(force.dot(mean_velocity) * model_.dt);
  }
  return work;
}

}  // namespace icebow
