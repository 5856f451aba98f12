#include "solver/contact.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tiny_hull.h"

using namespace icebow;

namespace {

ContactSettings settings(ContactRule rule, double friction) {
  ContactSettings s;
  s.rule = rule;
  s.friction = friction;
  s.V = 0.4;
  s.dt = 5e-5;
  s.particle_mass = 2e-3;
  s.penalty_stiffness = 52e6 * 0.013;
  return s;
}

ClosestPoint hit(double depth, const Vec3& normal) {
  ClosestPoint c;
  c.signed_distance = -depth;
  c.normal = normal.normalized();
  return c;
}

}  // namespace

TEST_CASE("relocation puts the particle on the surface and stops its approach, no more") {
  const Vec3 normal = Vec3(0.4, 0.0, -0.9).normalized();
  const ContactResponse r = respond(settings(ContactRule::relocation, 0.0), hit(1e-3, normal), Vec3::Zero());
  CHECK((r.push - 1e-3 * normal).norm() < 1e-15);
  const Vec3 relative = r.delta_v - Vec3(0.4, 0.0, 0.0);
  CHECK(std::abs(relative.dot(normal)) < 1e-12);
  CHECK(r.delta_v.cross(normal).norm() < 1e-12);  // frictionless: along the normal
}

TEST_CASE("a particle that already leaves the hull gets no impulse, however deep it is") {
  const ContactResponse r =
      respond(settings(ContactRule::relocation, 0.3), hit(5e-3, Vec3(1, 0, 0)), Vec3(0.9, 0.1, 0.0));
  CHECK(r.delta_v.norm() == 0.0);
  CHECK(r.push.norm() == Approx(5e-3));
}

TEST_CASE("friction obeys Coulomb's cone and never reverses sliding") {
  const Vec3 normal(1, 0, 0), sliding(0.3, 0.5, 0.0);  // approaches at 0.1 m/s, slides at 0.5 m/s
  const ContactResponse weak = respond(settings(ContactRule::relocation, 0.1), hit(1e-4, normal), sliding);
  CHECK(weak.delta_v.x() == Approx(0.1));
  CHECK(weak.delta_v.y() == Approx(-0.01));
  const ContactResponse strong = respond(settings(ContactRule::relocation, 50.0), hit(1e-4, normal), sliding);
  CHECK(strong.delta_v.y() == Approx(-0.5));
}

TEST_CASE("the paper's rule turns the push into velocity, capped at what the step can have covered") {
  const ContactSettings s = settings(ContactRule::paper, 0.0);
  const ContactResponse shallow = respond(s, hit(1e-5, Vec3(1, 0, 0)), Vec3::Zero());
  CHECK(shallow.delta_v.x() == Approx(1e-5 / s.dt));
  const ContactResponse deep = respond(s, hit(5e-3, Vec3(1, 0, 0)), Vec3::Zero());
  CHECK(deep.delta_v.x() == Approx(s.V));
}

TEST_CASE("the penalty rule is a spring") {
  const ContactSettings s = settings(ContactRule::penalty, 0.0);
  const ContactResponse r = respond(s, hit(1e-5, Vec3(0, 0, -1)), Vec3::Zero());
  CHECK(r.push.norm() == 0.0);
  CHECK(-r.delta_v.z() * s.particle_mass / s.dt == Approx(s.penalty_stiffness * 1e-5));
}

TEST_CASE("the crushing rule stops the approach with no more than the crushing force") {
  ContactSettings s = settings(ContactRule::crushing, 0.0);
  s.crushing_depth = 0.013;
  s.crushing_force = 5e4 * 0.013 * 0.013;
  const double yield = s.crushing_force * s.dt / s.particle_mass;  // change of velocity in a step
  const Vec3 normal(1, 0, 0), nearly_with_the_hull(s.V - 0.1 * yield, 0, 0);
  const ContactResponse held = respond(s, hit(5e-3, normal), nearly_with_the_hull);
  CHECK(held.delta_v.x() == Approx(0.1 * yield));
  CHECK(held.push.norm() == 0.0);
  CHECK(respond(s, hit(5e-3, normal), Vec3::Zero()).delta_v.x() == Approx(yield));
  CHECK(respond(s, hit(5e-3, normal), Vec3(2.0 * s.V, 0, 0)).delta_v.norm() == 0.0);
}

TEST_CASE("crushed ice is pushed out of the hull no faster than the hull sails") {
  ContactSettings s = settings(ContactRule::crushing, 0.0);
  s.crushing_depth = 0.013;
  s.crushing_force = 5e4 * 0.013 * 0.013;
  const ContactResponse r = respond(s, hit(0.02, Vec3(1, 0, 0)), Vec3::Zero());
  CHECK(r.delta_v.x() == Approx(s.V));
  CHECK(r.push.x() == Approx(s.V * s.dt));
}

TEST_CASE("sums of impulses do not depend on their order") {
  ExactImpulse forward(2e-3, 0.4, 0.013), backward = forward;
  for (int n = 0; n < 1000; ++n) forward.add(Vec3(1e-4 / (n + 1), 0, -3e-5 * n), Vec3(0.1, 0.01 * n, 0));
  for (int n = 999; n >= 0; --n) backward.add(Vec3(1e-4 / (n + 1), 0, -3e-5 * n), Vec3(0.1, 0.01 * n, 0));
  CHECK(forward.counts() == backward.counts());
  double expected = 0.0;
  for (int n = 0; n < 1000; ++n) expected += 1e-4 / (n + 1);
  CHECK(forward.counts()[0] * forward.linear() == Approx(expected).epsilon(1e-9));
}
