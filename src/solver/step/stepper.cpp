#include "solver/step/stepper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "base/units.h"
#include "solver/ice/mirror.h"

namespace icebow {
namespace {

// The part of the hull that can meet ice: from a little above the sheet (pieces ride up) down to the keel,
// and as far aft as the sheet's near edge will be at the end of the run; a moving window's edge stays where
// it is, however far the run is sailed on.
Box contact_region(const QuadMesh& hull, const Scenario& s, const Lattice& lattice, double start_x) {
  const Box box = bounding_box(hull);
  const double beam = box.upper.y() - box.lower.y(), margin = 10.0 * lattice.dx;
  Box region = box;
  region.lower -= Vec3::Constant(margin);
  region.upper += Vec3::Constant(margin);
  // How far aft of the stem there can be ice.
  const double astern =
      s.sheet.window_ahead > 0.0 ? s.sheet.length - s.sheet.window_ahead + block * lattice.dx : s.advance;
  region.lower.x() = std::max(region.lower.x(), -start_x - astern - 0.5 * beam);
  region.upper.z() = std::min(region.upper.z(), lattice.z(lattice.nz - 1) + 5.0 * s.ice.h);
  return region;
}

// Ice breaks some way beyond the ship's sides.
double broken_half_breadth(const QuadMesh& hull) {
  const Box box = bounding_box(hull);
  return 0.6 * (box.upper.y() - box.lower.y());
}

ContactSettings contact_settings(const Scenario& s, double dt, double dx) {
  ContactSettings c;
  c.rule = s.numerics.contact;
  c.friction = s.numerics.friction;
  c.V = s.V;
  c.dt = dt;
  c.particle_mass = s.ice.rho * dx * dx * dx;
  c.stiffness = contact_stiffness(s);
  c.crushing = {s.ice.crushing_pressure * dx * dx, c.stiffness, dx};
  return c;
}

}  // namespace

double first_touch_x(const QuadMesh& hull, const Lattice& lattice) {
  const double z_lo = lattice.z(0) - 0.5 * lattice.dx, z_hi = z_lo + lattice.nz * lattice.dx;
  double front = -1e300;
  for (const auto& quad : hull.quads) {
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 a = hull.points[quad[corner]], b = hull.points[quad[(corner + 1) % 4]];
      if (a.z() > b.z()) std::swap(a, b);
      if (b.z() < z_lo || a.z() > z_hi) continue;
      const Vec3 edge = b - a;
      const double t0 = edge.z() > 0.0 ? std::max(0.0, (z_lo - a.z()) / edge.z()) : 0.0;
      const double t1 = edge.z() > 0.0 ? std::min(1.0, (z_hi - a.z()) / edge.z()) : 1.0;
      front = std::max({front, a.x() + t0 * edge.x(), a.x() + t1 * edge.x()});
    }
  }
  if (front == -1e300)
    throw InputError("the hull does not reach the ice: check its draught and the water level");
  return -front;
}

Stepper::Stepper(const Communicator& comm, const QuadMesh& hull, const Scenario& s, const Lattice& lattice,
                 double dt, double hull_x)
    : comm_(comm),
      dt_(dt),
      V_(s.V),
      start_x_(hull_x),
      window_ahead_(s.sheet.window_ahead),
      material_(make_material(s.ice, lattice.dx, s.numerics.horizon_ratio)),
      sheet_(s, lattice,
             make_partition(lattice, comm.rank(), comm.size(), comm.size() > 1 ? s.numerics.ranks_along_x : 0,
                            column_costs(lattice, broken_half_breadth(hull))),
             material_),
      contact_(hull, contact_region(hull, s, lattice, hull_x), contact_settings(s, dt, lattice.dx)),
      impulse_(s.ice.rho * lattice.particle_volume(), s.V, lattice.dx),
      no_impulse_(impulse_),
      ledger_(EnergyModel(s, lattice, material_, dt)),
      surroundings_(comm, s, lattice, material_, ledger_.model()),
      schedule_(comm, sheet_, timer_) {
  drift_.dt = dt;
  drift_.gravity = s.water.buoyancy_and_gravity ? gravity : 0.0;
  drift_.lift = s.water.buoyancy_and_gravity ? gravity * s.water.rho / s.ice.rho : 0.0;
  drift_.inverse_dx = 1.0 / lattice.dx;
  drift_.V = V_;
}

// Velocity Verlet in its half-step form: `v` lives between the positions, one force evaluation a step.
void Stepper::step() {
  if (window_is_due(steps_)) move_window();
  ++steps_;
  contacts_ = 0;
  const std::int64_t broke = schedule_.run([this](int jl0, int jl1) { move(jl0, jl1); },
                                           [this] { surroundings_.moved(sheet_, steps_); });
  broken_bonds_ += broke;
  if (broke > 0) mirror_bonds_beyond_ends(sheet_);
  // Before the surroundings: their work is counted by velocities, that of bonds by displacements, and the
  // ledger wants the latter's accelerations alone.
  ledger_.close_step(sheet_);
  timer_.lap(Phase::energy);
  if (!surroundings_.act()) return;
  ledger_.add_work(surroundings_.apply(sheet_, steps_, ledger_.strikes()));
  timer_.lap(Phase::surroundings);
}

// After so many steps the ship is so near the end of the ice that less than asked for lies ahead.
bool Stepper::window_is_due(std::int64_t steps) const {
  const Lattice& l = sheet_.lattice;
  return window_ahead_ > 0.0 && V_ * (steps * dt_) > (l.first + l.nx) * l.dx - window_ahead_;
}

void Stepper::move_window() {
  const EnergyCounts before = sheet_energy(sheet_, ledger_.model());
  std::vector<double> touches = comm_.gather_everywhere(ledger_.record(sheet_));
  sheet_.drop_first_block(comm_);
  // The ice along the cut has lost bonds: its elastic energy is that of what is left.
  broken_bonds_ += schedule_.look_again();
  ledger_.move_window(std::move(touches), sheet_);
  contact_.look_again();
  surroundings_.renumbered(sheet_);
  const EnergyCounts after = sheet_energy(sheet_, ledger_.model());
  dropped_.kinetic += before.kinetic - after.kinetic;
  dropped_.potential += before.potential - after.potential;
  dropped_.elastic += before.elastic - after.elastic;
  dropped_.fracture += before.fracture - after.fracture;
  timer_.lap(Phase::other);
}

void Stepper::move(int jl0, int jl1) {
  sheet_.drift(drift_, jl0, jl1);
  timer_.lap(Phase::drift);
  contacts_ += contact_.apply(sheet_, hull_x(), jl0, jl1, impulse_, ledger_);
  timer_.lap(Phase::contact);
}

void Stepper::restore(std::int64_t steps, std::int64_t broken_bonds, const ExactImpulse::Counts& impulse,
                      const EnergyCounts& dropped, const SurroundingsCounts& given_away) {
  dropped_ = dropped;
  contact_.look_again();
  surroundings_.restore(given_away);
  surroundings_.renumbered(sheet_);
  steps_ = steps;
  broken_bonds_ = broken_bonds;
  impulse_.counts() = impulse;
}

ExactImpulse Stepper::take_impulse() {
  return std::exchange(impulse_, no_impulse_);
}

}  // namespace icebow
