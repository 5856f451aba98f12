#include "bench/contact_share.h"

#include <ctime>

#include "base/communicator.h"
#include "base/units.h"
#include "solver/contact.h"
#include "solver/halo.h"
#include "solver/stability.h"
#include "tests/solver/shapes.h"

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
  return s;
}

// The pieces of Stepper::step(), so that contact can be timed on its own.
class Run {
 public:
  Run(const Scenario& s, const QuadMesh& hull)
      : V_(s.V),
        hull_box_(bounding_box(hull)),
        lattice_(make_lattice(s)),
        material_(make_material(s.ice, lattice_.dx, s.numerics.horizon_ratio)),
        sheet_(s, lattice_, make_partition(lattice_, 0, 1), material_),
        dt_(s.numerics.dt_fraction *
            stable_time_step(sheet_.stencil, material_, lattice_.dx, s.ice.rho, true)),
        contact_(hull, region(s), settings(s)),
        impulse_(s.ice.rho * lattice_.particle_volume(), s.V, lattice_.dx) {
    drift_.dt = dt_;
    drift_.gravity = gravity;
    drift_.lift = gravity * s.water.rho / s.ice.rho;
    drift_.inverse_dx = 1.0 / lattice_.dx;
  }

  // Returns the number of particles in contact; adds the time of contact.
  int step(std::clock_t& contact_time) {
    hull_x_ += V_ * dt_;
    for (int c = 0; c < 3; ++c) {
      const double shift = c == 0 ? hull_x_ : 0.0;
      drift_.box_lo[c] = hull_box_.lower[c] + shift - 1e-5;
      drift_.box_hi[c] = hull_box_.upper[c] + shift + 1e-5;
    }
    sheet_.drift(drift_);
    const std::clock_t start = std::clock();
    const int contacts = contact_.apply(sheet_, hull_x_, 0, sheet_.layout.columns, impulse_);
    contact_time += std::clock() - start;
    sheet_.dilatation();
    sheet_.force();
    return contacts;
  }

 private:
  Box region(const Scenario& s) const {
    Box box = hull_box_;
    box.lower -= Vec3::Constant(10.0 * lattice_.dx);
    box.upper += Vec3::Constant(10.0 * lattice_.dx);
    box.lower.x() = std::max(box.lower.x(), -entered - 1.0);
    box.upper.z() = std::min(box.upper.z(), lattice_.z(lattice_.nz - 1) + 5.0 * s.ice.h);
    return box;
  }

  ContactSettings settings(const Scenario& s) const {
    ContactSettings c;
    c.friction = s.numerics.friction;
    c.V = s.V;
    c.dt = dt_;
    c.particle_mass = s.ice.rho * lattice_.particle_volume();
    return c;
  }

  double V_, hull_x_ = entered;
  Box hull_box_;
  Lattice lattice_;
  Material material_;
  IceSheet sheet_;
  double dt_;
  HullContact contact_;
  ExactImpulse impulse_;
  DriftSettings drift_{};
};

}  // namespace

// The hull is put into the sheet at once: the first step pushes the ice in its way onto its surface, where it
// breaks. The steps that are not timed let it settle, so that contact is as in a run: rubble along the hull,
// ice being broken at the bow.
ContactShare contact_share(int quads) {
  const QuadMesh hull = shapes::hull(6.0, 0.92, 0.54, quads);
  Run run(paper_slab(), hull);
  std::clock_t contact_time = 0;
  for (int n = 0; n < settling_steps; ++n) run.step(contact_time);

  contact_time = 0;
  std::int64_t contacts = 0;
  const std::clock_t start = std::clock();
  for (int n = 0; n < timed_steps; ++n) contacts += run.step(contact_time);
  const double ms = 1e3 / CLOCKS_PER_SEC / timed_steps;
  return {hull.quads.size(), static_cast<int>(contacts / timed_steps), ms * double(std::clock() - start),
          ms * double(contact_time)};
}

}  // namespace icebow
