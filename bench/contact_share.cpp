#include "bench/contact_share.h"

#include <chrono>

#include "base/communicator.h"
#include "solver/lattice/stability.h"
#include "solver/step/stepper.h"
#include "tests/support/shapes.h"

namespace icebow {
namespace {

constexpr double entered = 1.5;  // stem's way into the sheet at the start [m]
constexpr int settling_steps = 300, timed_steps = 100;

Scenario paper_slab() {
  Scenario s;
  s.ice = {0.039, 826.6, 52e6, 0.33, 0.0052, 0.0};
  s.sheet = {6.5, 3.25, FixedEdges::sides};
  s.numerics.dx = 0.013;
  s.numerics.friction = 0.1;
  s.V = 0.41;
  s.advance = 1.0;
  return s;
}

}  // namespace

// The hull is put into the sheet at once: the first step pushes the ice in its way onto its surface, where it
// breaks. The steps that are not timed let it settle, so that contact is as in a run: rubble along the hull,
// ice being broken at the bow.
ContactShare contact_share(int quads) {
  const Scenario s = paper_slab();
  const QuadMesh hull = shapes::hull(6.0, 0.92, 0.54, quads);
  const Lattice lattice = make_lattice(s);
  const Material material = make_material(s.ice, lattice.dx, s.numerics.horizon_ratio);
  const double dt =
      s.numerics.dt_fraction * stable_time_step(make_stencil(lattice.nz, lattice.dx, material.delta),
                                                material, lattice.dx, s.ice.rho, true);
  Stepper stepper(Communicator::serial(), hull, s, lattice, dt, entered);
  for (int n = 0; n < settling_steps; ++n) stepper.step();

  std::int64_t contacts = 0;
  const double contact_before = stepper.timer().seconds(Phase::contact);
  const auto start = std::chrono::steady_clock::now();
  for (int n = 0; n < timed_steps; ++n) {
    stepper.step();
    contacts += stepper.contacts();
  }
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  const double contact = stepper.timer().seconds(Phase::contact) - contact_before, ms = 1e3 / timed_steps;
  return {hull.quads.size(), static_cast<int>(contacts / timed_steps), ms * whole.count(), ms * contact};
}

}  // namespace icebow
