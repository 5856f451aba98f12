#include "solver/recorder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/units.h"

namespace icebow {
namespace {

struct Motion {
  std::int64_t energy_quanta = 0;
  double fastest = 0.0;     //!< [m/s]
  double x = 0.0, y = 0.0;  // reference position of the fastest particle [m]
};

// NaN counts as infinitely fast.
Motion motion(const IceSheet& sheet, double mass, double quantum) {
  Motion m;
  const Layout& layout = sheet.layout;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const std::size_t row = layout.row(jl, k);
      for (int l = 0; l < layout.blocks * block; ++l) {
        double v2 = 0.0;
        for (const Field& v : sheet.v) v2 += v[row + l] * v[row + l];
        if (!(v2 < 1e12)) v2 = 1e12;
        m.energy_quanta += std::llround(std::min(0.5 * mass * v2 / quantum, 1e12));
        if (v2 > m.fastest * m.fastest) {
          m.fastest = std::sqrt(v2);
          m.x = sheet.lattice.x(layout.i0 + l);
          m.y = sheet.lattice.y(layout.j0 + jl);
        }
      }
    }
  }
  return m;
}

}  // namespace

double sampling_interval(double h) {
  return 0.08 * std::sqrt(h / gravity);
}

Recorder::Recorder(const Communicator& comm, const Stepper& stepper, const Scenario& s)
    : comm_(comm), particle_mass_(s.ice.rho * stepper.sheet().lattice.particle_volume()), V_(s.V) {
  const Material& m = stepper.material();
  fastest_allowed_ = std::sqrt((m.kappa + 4.0 * m.mu / 3.0) / s.ice.rho);  // P wave
  energy_quantum_ = std::ldexp(particle_mass_ * V_ * V_, -24);
  steps_per_sample_ = std::max<std::int64_t>(1, std::llround(sampling_interval(s.ice.h) / stepper.dt()));
  history_.interval = steps_per_sample_ * stepper.dt();
}

bool Recorder::sample(Stepper& stepper, std::string& reason) {
  const Motion m = motion(stepper.sheet(), particle_mass_, energy_quantum_);
  ExactImpulse impulse = stepper.take_impulse();
  std::int64_t totals[9];
  std::copy(impulse.counts().begin(), impulse.counts().end(), totals);
  totals[6] = stepper.broken_bonds();
  totals[7] = stepper.contacts();
  totals[8] = m.energy_quanta;
  comm_.sum(totals, 9);

  HistoryRow row;
  row.t = stepper.time();
  row.advance = V_ * row.t;
  for (int c = 0; c < 3; ++c) {
    row.F[c] = totals[c] * impulse.linear() / history_.interval;
    row.M[c] = totals[c + 3] * impulse.angular() / history_.interval;
  }
  row.broken_bonds = totals[6];
  row.contacts = totals[7];
  row.kinetic_energy = totals[8] * energy_quantum_;
  history_.rows.push_back(row);

  const double fastest = comm_.max(m.fastest);
  if (fastest <= fastest_allowed_) return true;
  // The rank that holds the runaway particle tells the others where it is.
  const double holder = comm_.max(m.fastest == fastest ? comm_.rank() : -1.0);
  double place[2] = {m.x, m.y};
  comm_.broadcast(place, sizeof place, static_cast<int>(holder));
  char text[256];
  std::snprintf(
      text, sizeof text,
      "unstable at step %lld (t = %.4g s, advance %.4g m): a particle first at x = %.3f m, y = %.3f m moves "
      "faster than sound (%.3g m/s); take a smaller time step",
      static_cast<long long>(stepper.steps()), row.t, row.advance, place[0], place[1], fastest);
  reason = text;
  return false;
}

}  // namespace icebow
