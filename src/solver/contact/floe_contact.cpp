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
  law.creep = creep_share * law.damping;
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

// Of the pairs those that touch, and how; filled up with pairs at no distance, between which nothing acts.
int FloeContact::find_touching() {
  const std::vector<ContactPairs::Pair>& pairs = pairs_.all();
  const std::size_t room = pairs.size() + floe_pairs_at_once;
  touching_.resize(room);
  for (int c = 0; c < 3; ++c) {
    away_[c].resize(room);
    velocity_[c].resize(room);
    force_[c].resize(room);
  }
  const double distance2 = law_.distance * law_.distance;
  int n = 0;
  for (std::size_t at = 0; at < pairs.size(); ++at) {
    const Vec3 &one = pairs_.position(pairs[at].first), &other = pairs_.position(pairs[at].second);
    const double side = pairs[at].kind == ContactPairs::mirrored ? -1.0 : 1.0;
    const double x = other.x() - one.x(), y = side * other.y() - one.y(), z = other.z() - one.z();
    touching_[n] = static_cast<int>(at);
    away_[0][n] = x;
    away_[1][n] = y;
    away_[2][n] = z;
    // Without a branch, which no processor could foresee.
    n += x * x + y * y + z * z < distance2 ? 1 : 0;
  }
  for (int c = 0; c < 3; ++c) {
    std::fill_n(&away_[c][n], floe_pairs_at_once, 0.0);
    std::fill_n(&velocity_[c][n], floe_pairs_at_once, 0.0);
  }
  return n;
}

// In whole quanta: the same whichever pair comes first.
template <class Real>
void FloeContact::add_forces(const IceSheet& sheet) {
  const int n = find_touching();
  const Real* const v[3] = {sheet.v[0].data<Real>(), sheet.v[1].data<Real>(), sheet.v[2].data<Real>()};
  for (int at = 0; at < n; ++at) {
    const ContactPairs::Pair& pair = pairs_.all()[touching_[at]];
    const Vec3 one = pairs_.velocity(v, pair.first), other = pairs_.velocity(v, pair.second);
    velocity_[0][at] = other.x() - one.x();
    velocity_[1][at] = (pair.kind == ContactPairs::mirrored ? -other.y() : other.y()) - one.y();
    velocity_[2][at] = other.z() - one.z();
  }
  const int whole = (n + floe_pairs_at_once - 1) / floe_pairs_at_once * floe_pairs_at_once;
  sheet.kernel.floe_forces(law_,
                           {whole,
                            {away_[0].data(), away_[1].data(), away_[2].data()},
                            {velocity_[0].data(), velocity_[1].data(), velocity_[2].data()},
                            {force_[0].data(), force_[1].data(), force_[2].data()}},
                           1.0 / quantum_);
  forces_.assign(pairs_.own(), Force{});
  for (int at = 0; at < n; ++at) {
    const ContactPairs::Pair& pair = pairs_.all()[touching_[at]];
    for (int c = 0; c < 3; ++c) {
      forces_[pair.first][c] += force_[c][at];
      if (pair.kind == ContactPairs::both) forces_[pair.second][c] -= force_[c][at];
    }
  }
}

// Returns the work of the force on the particle in this step [J].
template <class Real>
double FloeContact::push(IceSheet& sheet, int n, const Vec3& force) const {
  const std::size_t p = pairs_.address(n);
  const Vec3 by_contact = force * (1.0 / model_.mass);
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

template <class Real>
FloeWork FloeContact::push_all(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  add_forces<Real>(sheet);
  const bool relocated =
      std::any_of(strikes.begin(), strikes.end(), [](const HullStrike& s) { return s.push != Vec3::Zero(); });
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
    joules += push<Real>(sheet, n, force);
    if (relocated) work.by_hull -= model_.quanta(force.dot(push_at(p, strikes)));
  }
  work.taken += work.by_hull - model_.quanta(joules);
  return work;
}

FloeWork FloeContact::apply(IceSheet& sheet, const std::vector<HullStrike>& strikes) {
  pairs_.refresh(sheet);
  return sheet.precision == Precision::fp64 ? push_all<double>(sheet, strikes)
                                            : push_all<float>(sheet, strikes);
}

}  // namespace icebow
