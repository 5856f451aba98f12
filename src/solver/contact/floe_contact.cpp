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
  // What is no number counts as none.
  const double pressed = std::min(std::max(0.0, stiffness * overlap - damping * approach), strongest);
  if (pressed == 0.0) return Vec3::Zero();
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
      quantum_(std::ldexp(law_.strongest, -40)),
      model_(model),
      pairs_(comm, 1.25 * law_.distance) {}

void FloeContact::find_pairs(const IceSheet& sheet) {
  if (acts_) pairs_.find(sheet);
}

// In whole quanta: the same whichever pair comes first.
void FloeContact::add_forces(const IceSheet& sheet) {
  forces_.assign(pairs_.own(), Force{});
  const double per_quantum = 1.0 / quantum_;
  for (const ContactPairs::Pair& pair : pairs_.all()) {
    Vec3 other = pairs_.position(pair.second);
    if (pair.kind == ContactPairs::mirrored) other.y() = -other.y();
    const Vec3 away = other - pairs_.position(pair.first);
    if (!(away.squaredNorm() < law_.distance * law_.distance)) continue;
    Vec3 velocity = pairs_.velocity(sheet, pair.second);
    if (pair.kind == ContactPairs::mirrored) velocity.y() = -velocity.y();
    const Vec3 force = law_.force(away, velocity - pairs_.velocity(sheet, pair.first)) * per_quantum;
    for (int c = 0; c < 3; ++c) {
      const std::int64_t quanta = std::llrint(force[c]);
      forces_[pair.first][c] += quanta;
      if (pair.kind == ContactPairs::both) forces_[pair.second][c] -= quanta;
    }
  }
}

// Returns the work of the force on the particle in this step [J].
template <class Real>
double FloeContact::push(IceSheet& sheet, int n, const Vec3& force) const {
  const std::size_t p = pairs_.address(n);
  const Vec3 by_contact = force / model_.mass;
  Vec3 acceleration, velocity;
  for (int c = 0; c < 3; ++c) {
    Real& a = sheet.acceleration[c].data<Real>()[p];
    acceleration[c] = a + by_contact[c];
    a = static_cast<Real>(acceleration[c]);
    velocity[c] = sheet.v[c].data<Real>()[p];
  }
  acceleration.z() += model_.weight_and_lift(pairs_.position(n).z());
  return force.dot(velocity + 0.5 * model_.dt * acceleration) * model_.dt;
}

FloeWork FloeContact::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  pairs_.refresh(sheet);
  add_forces(sheet);
  const bool relocated =
      std::any_of(strikes.begin(), strikes.end(), [](const HullStrike& s) { return s.push != Vec3::Zero(); });
  const bool fp64 = sheet.precision == Precision::fp64;
  FloeWork work;
  double joules = 0.0;  // of the block at hand: blocks are whole on every rank
  std::size_t at = 0;
  for (int n = 0; n < pairs_.own(); ++n) {
    const Force& quanta = forces_[n];
    if ((quanta[0] | quanta[1] | quanta[2]) == 0) continue;
    const std::size_t p = pairs_.address(n);
    if (p / block != at) {
      work.taken -= model_.quanta(joules);
      joules = 0.0;
      at = p / block;
    }
    const Vec3 force = quantum_ * Vec3(double(quanta[0]), double(quanta[1]), double(quanta[2]));
    joules += fp64 ? push<double>(sheet, n, force) : push<float>(sheet, n, force);
    if (relocated) work.by_hull -= model_.quanta(force.dot(push_at(p, strikes)));
  }
  work.taken += work.by_hull - model_.quanta(joules);
  return work;
}

}  // namespace icebow
