#include "solver/contact/contact.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

ContactSettings settings(ContactRule rule, double friction) {
  ContactSettings s;
  s.rule = rule;
  s.friction = friction;
  s.V = 0.4;
  s.dt = 5e-5;
  s.particle_mass = 2e-3;
  s.stiffness = 52e6 * 0.013;
  return s;
}

// Of a rule without memory.
ContactResponse respond(const ContactSettings& s, const ClosestPoint& hit, const Vec3& velocity) {
  double crushed = 0.0;
  return icebow::respond(s, hit, velocity, crushed);
}

ClosestPoint hit(double depth, const Vec3& normal) {
  ClosestPoint c;
  c.signed_distance = -depth;
  c.normal = normal.normalized();
  return c;
}

// A wall of this slope that has cut into ice of three layers, as a hull drives it on by one spacing: mean and
// standard deviation of its force over the crushing pressure on the area it cuts, of a law that rises and
// falls over this part of the spacing.
struct Ripple {
  double mean, deviation;
};

Ripple ripple(double slope_deg, double ramp) {
  const double slope = slope_deg * M_PI / 180.0, sine = std::sin(slope), cosine = std::cos(slope);
  const auto bearable = [&](double depth) {
    return std::clamp(depth / ramp, 0.0, 1.0) - std::clamp((depth - 1.0) / ramp, 0.0, 1.0);
  };
  constexpr int positions = 64, layers = 3, columns = 40;
  double sum = 0.0, squares = 0.0;
  for (int n = 0; n < positions; ++n) {
    double force = 0.0;
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < columns; ++i)  // the wall is at x = 20 at the lowest layer
        force += bearable((20.0 + double(n) / positions - i) * sine + k * cosine);
    force *= sine / layers;
    sum += force / positions;
    squares += force * force / positions;
  }
  return {sum, std::sqrt(std::max(0.0, squares - sum * sum))};
}

}  // namespace

TEST_CASE("a wall's force ripples least where it rises over three quarters of a spacing") {
  double worst[4] = {};
  const double ramps[4] = {0.25, 0.5, CrushingLaw::ramp, 1.0};
  for (int n = 0; n < 4; ++n) {
    for (double slope = 20.0; slope <= 90.0; slope += 1.0) {
      const Ripple found = ripple(slope, ramps[n]);
      // Every depth of a particle is met alike as the wall goes on by a spacing; 64 places of it.
      CHECK(found.mean == Approx(1.0).epsilon(0.002));  // 64 places stand for all depths
      worst[n] = std::max(worst[n], found.deviation);
    }
    INFO("ramp " << ramps[n] << " of a spacing: ripple " << worst[n]);
    CHECK(worst[n] < 0.3);
  }
  INFO("0.25: " << worst[0] << ", 0.5: " << worst[1] << ", 0.75: " << worst[2] << ", 1: " << worst[3]);
  CHECK(worst[2] < 0.03);  // docs/theory.md, eq. (40)
  CHECK(worst[0] > 5.0 * worst[2]);
  CHECK(worst[1] > 2.0 * worst[2]);
  CHECK(worst[3] > 2.0 * worst[2]);
}

TEST_CASE("relocation puts the particle on the surface and stops its approach, no more") {
  const Vec3 normal = Vec3(0.4, 0.0, -0.9).normalized();
  const ContactResponse r = respond(settings(ContactRule::relocation, 0.0), hit(1e-3, normal), Vec3::Zero());
  CHECK((r.push - 1e-3 * normal).norm() < 1e-15);  // rounding
  const Vec3 relative = r.delta_v - Vec3(0.4, 0.0, 0.0);
  CHECK(std::abs(relative.dot(normal)) < 1e-12);  // rounding
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
  CHECK(-r.delta_v.z() * s.particle_mass / s.dt == Approx(s.stiffness * 1e-5));
}

namespace {

constexpr double spacing = 0.013, strength = 104e3 * spacing * spacing;

CrushingLaw crushing_law() {
  return {strength, 0.25 * 52e6 * spacing, spacing};
}

}  // namespace

TEST_CASE("crushing: rows of ice one behind the other bear the crushing pressure together, at every depth") {
  const CrushingLaw law = crushing_law();
  CHECK(law.bearable(0.0) == 0.0);
  for (double depth = spacing; depth < 2.0 * spacing; depth += 0.01 * spacing)
    CHECK(law.bearable(depth) + law.bearable(depth - spacing) ==
          Approx(strength).epsilon(1e-12));  // rounding
}

TEST_CASE("crushing: pushing the hull through a particle costs the crushing pressure times its volume") {
  const CrushingLaw law = crushing_law();
  double crushed = 0.0, work = 0.0;
  const double step = 1e-4 * spacing;
  for (double depth = 0.5 * step; !law.used_up(crushed); depth += step)
    work += law.force(depth, crushed) * step;
  CHECK(work == Approx(strength * spacing).epsilon(1e-3));  // the sum over steps of 1e-4 of the depth
  CHECK(law.force(3.0 * spacing, crushed) == 0.0);          // rubble counts no face a second time
}

TEST_CASE("crushing: unloading gives back what the contact stores and no more") {
  const CrushingLaw law = crushing_law();
  double crushed = 0.0;
  const double deep = spacing, loaded = law.force(deep, crushed);
  REQUIRE(loaded == Approx(strength));
  double back = 0.0;
  const double step = 1e-5 * spacing;
  for (double depth = deep - 0.5 * step; depth > 0.9 * deep; depth -= step)
    back += law.force(depth, crushed) * step;
  CHECK(back == Approx(0.5 * strength * strength / law.stiffness).epsilon(0.01));  // the sum over steps
  CHECK(back < 0.01 * strength * spacing);
  CHECK(law.force(0.9 * deep, crushed) == 0.0);  // the hull has cut so far: nothing presses there
  CHECK(law.force(deep, crushed) == Approx(strength));
}

TEST_CASE("crushing: the force goes by depth, whatever the step and the speed") {
  ContactSettings s = settings(ContactRule::crushing, 0.0);
  s.crushing = crushing_law();
  for (const double dt : {1e-5, 5e-5}) {
    s.dt = dt;
    for (const double v : {0.0, 0.3}) {
      double crushed = 0.0;
      const ContactResponse r = respond(s, hit(spacing, Vec3(1, 0, 0)), Vec3(v, 0, 0), crushed);
      CHECK(r.delta_v.x() * s.particle_mass / s.dt == Approx(strength));
      CHECK(r.push.norm() == 0.0);
    }
  }
}

TEST_CASE("crushing: friction goes with the force that acts and never reverses sliding") {
  ContactSettings s = settings(ContactRule::crushing, 0.1);
  s.crushing = crushing_law();
  s.dt = 1e-6;
  double crushed = 0.0;
  const ContactResponse r = respond(s, hit(spacing, Vec3(1, 0, 0)), Vec3(0.4, 0.5, 0.0), crushed);
  CHECK(-r.delta_v.y() == Approx(0.1 * r.delta_v.x()));
  crushed = 0.0;
  const ContactResponse slow = respond(s, hit(spacing, Vec3(1, 0, 0)), Vec3(0.4, 1e-9, 0.0), crushed);
  CHECK(-slow.delta_v.y() == Approx(1e-9));
}

TEST_CASE("sums of impulses do not depend on their order") {
  ExactImpulse forward(2e-3, 0.4, 0.013), backward = forward;
  for (int n = 0; n < 1000; ++n) forward.add(Vec3(1e-4 / (n + 1), 0, -3e-5 * n), Vec3(0.1, 0.01 * n, 0));
  for (int n = 999; n >= 0; --n) backward.add(Vec3(1e-4 / (n + 1), 0, -3e-5 * n), Vec3(0.1, 0.01 * n, 0));
  CHECK(forward.counts() == backward.counts());
  double expected = 0.0;
  for (int n = 0; n < 1000; ++n) expected += 1e-4 / (n + 1);
  CHECK(forward.counts()[0] * forward.linear() == Approx(expected).epsilon(1e-9));  // counted in whole quanta
}
