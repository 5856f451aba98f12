// A wall that the hull drives into ice too strong to break: force and work of crushing. See
// docs/verification.md.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "base/units.h"
#include "solver/contact/contact.h"
#include "solver/lattice/stability.h"
#include "solver/step/stepper.h"
#include "tests/support/ice_block.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

constexpr double knot = 0.514444 / 5.0;  // at a scale of 25 [m/s]

// Of ice of 1 m at a scale of 25: its modulus, crushing pressure and speeds. At low speeds the pressure is
// above what a rule that stops a particle once a step could bear.
struct Wall {
  double slope_deg = 90.0, knots = 4.0, step = 0.95;
  int columns = 6;  // of particles, across the wall
  bool floe_contact = false;
  double modulus = 52e6;  //!< [Pa]
};

Scenario scenario(const Wall& wall) {
  Scenario s = block_scenario(32, wall.columns + 10, 3);  // three columns are held on either side
  s.sheet.fixed = FixedEdges::sides_and_far;
  s.ice.E = wall.modulus;
  s.ice.s0 = 0.0;
  s.ice.tensile_strength = 1e9;
  s.ice.crushing_pressure = 104e3;
  s.numerics.contact = ContactRule::crushing;
  s.numerics.floe_contact = wall.floe_contact;
  s.V = wall.knots * knot;
  s.advance = 0.3;
  return s;
}

double time_step(const Scenario& s) {
  const Lattice lattice = make_lattice(s);
  const Material m = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  const double limit =
      stable_time_step(make_stencil(lattice.nz, lattice.dx, m.delta), m, lattice.dx, s.ice.rho, true);
  return with_contact(limit, contact_stiffness(s), s.ice.rho * lattice.particle_volume());
}

struct Found {
  double force;  // mean, along the course, once the wall cuts the whole thickness
  double work;   // of the hull, from the first touch on
  // over the crushing pressure on the area cut, and times the volume cut
};

Found push(const Wall& wall) {
  const Scenario s = scenario(wall);
  const Lattice lattice = make_lattice(s);
  const double slope = radians(wall.slope_deg), dx = lattice.dx;
  const QuadMesh hull = sloping_box(slope, wall.columns * dx, 0.2, 0.2, 0.5);
  // Particles are touched at their centres.
  const double first = first_touch_x(hull, lattice) + 0.5 * dx;
  Stepper stepper(Communicator::serial(), hull, s, lattice, wall.step * time_step(s), first);
  const double area = wall.columns * dx * s.ice.h;
  const double whole = s.ice.h / std::tan(slope) + 2.0 * dx / std::sin(slope), end = whole + 6.0 * dx;
  double all = 0.0, steady = 0.0, from = 0.0;
  while (s.V * stepper.time() < end) {
    stepper.step();
    const ExactImpulse impulse = stepper.take_impulse();
    const double along = -impulse.linear() * double(impulse.counts()[0]);
    all += along;
    if (s.V * stepper.time() < whole) {
      from = stepper.time();
    } else {
      steady += along;
    }
  }
  // Cut by then: each layer from where the wall meets it on, less 3/8 of a spacing along the wall's normal,
  // the mean of a particle's rise.
  double volume = 0.0;
  for (int k = 0; k < lattice.nz; ++k) {
    const double met =
        (lattice.nz - k - 0.5) * dx / std::tan(slope) + 0.5 * CrushingLaw::ramp * dx / std::sin(slope);
    volume += wall.columns * dx * dx * (end - met);
  }
  return {steady / (stepper.time() - from) / (s.ice.crushing_pressure * area),
          all * s.V / (s.ice.crushing_pressure * volume)};
}

void check(const Wall& wall) {
  const Found found = push(wall);
  INFO("slope " << wall.slope_deg << " deg, " << wall.knots << " kn, " << wall.step
                << " of the time-step limit, " << wall.columns << " columns, contact of floes "
                << wall.floe_contact << ": force " << found.force << ", work " << found.work << " of theory");
  // The sheet gives way by some per cent of a spacing, and what it stores is in the work.
  CHECK(found.force == Approx(1.0).epsilon(0.02));  // the sheet gives way a little
  CHECK(found.work == Approx(1.0).epsilon(0.05));   // what the sheet stores is in the work
}

}  // namespace

TEST_CASE("a vertical wall feels the crushing pressure on the area it cuts, at every speed and time step") {
  for (const double knots : {0.5, 2.0, 8.0}) check({90.0, knots});
  check({90.0, 2.0, 0.475});
}

TEST_CASE(
    "a wall feels the crushing pressure on the area it cuts whatever its slope, width and the ice around") {
  check({60.0, 4.0});
  check({60.0, 4.0, 0.475});
  check({90.0, 4.0, 0.95, 2});  // every column is at the wall's edge
  check({90.0, 4.0, 0.95, 16});
  check({90.0, 4.0, 0.95, 6, true});
  check({60.0, 4.0, 0.95, 6, true});
  // Stiffer: such a wall presses ice that cannot break down and ahead, by a tenth of the force with 52 MPa.
  check({30.0, 2.0, 0.95, 4, false, 520e6});
}

TEST_CASE("a wall at every speed of a ship: the table", "[.long]") {
  for (const double slope : {90.0, 60.0, 30.0}) {
    for (const double knots : {0.5, 1.0, 2.0, 4.0, 8.0}) {
      for (const double step : {0.95, 0.475}) {
        const Found found = push({slope, knots, step, 6, false, slope < 60.0 ? 520e6 : 52e6});
        std::printf("%4.0f deg %4.1f kn, %.3f of the limit: force %.4f, work %.4f\n", slope, knots, step,
                    found.force, found.work);
      }
    }
  }
}
