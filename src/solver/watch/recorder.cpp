#include "solver/watch/recorder.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "solver/model/record_interval.h"
#include "solver/watch/runaway.h"

namespace icebow {
namespace {

// The other half's impulse is the mirror image in the plane y = 0: of a vector its y changes sign, of a
// moment x and z.
void complete_symmetric(std::int64_t (&impulse_and_moment)[8]) {
  for (int c : {0, 2, 4}) impulse_and_moment[c] *= 2;
  for (int c : {1, 3, 5}) impulse_and_moment[c] = 0;
}

}  // namespace

Recorder::Recorder(const Communicator& comm, const Stepper& stepper, const Scenario& s, double dt_limit)
    : comm_(comm),
      V_(s.V),
      dt_limit_(dt_limit),
      steps_per_sample_(sampling_steps(s.ice.h, stepper.dt())),
      watch_(comm, stepper, s, steps_per_sample_) {
  const Material& m = stepper.material();
  fastest_allowed_ = std::sqrt((m.kappa + 4.0 * m.mu / 3.0) / s.ice.rho);  // P wave
  history_.interval = steps_per_sample_ * stepper.dt();
}

// NaN counts as infinitely fast.
Recorder::Motion Recorder::motion(const IceSheet& sheet) {
  Motion m;
  const Layout& layout = sheet.layout;
  for (int jl = 0; jl < layout.columns; ++jl) {
    for (int k = 0; k < layout.nz; ++k) {
      const std::size_t row = layout.row(jl, k);
      for (int l = 0; l < layout.blocks * block; ++l) {
        double v2 = 0.0;
        for (const Field& v : sheet.v) v2 += v[row + l] * v[row + l];
        if (!(v2 < 1e12)) v2 = 1e12;
        if (v2 > m.fastest * m.fastest) {
          m.fastest = std::sqrt(v2);
          m.where = row + l;
        }
      }
    }
  }
  return m;
}

bool Recorder::sample(Stepper& stepper, std::string& reason) {
  const Motion m = motion(stepper.sheet());
  ExactImpulse impulse = stepper.take_impulse();
  std::int64_t totals[8];
  std::copy(impulse.counts().begin(), impulse.counts().end(), totals);
  totals[6] = stepper.broken_bonds();
  totals[7] = stepper.contacts();
  comm_.sum(totals, 8);

  HistoryRow row;
  row.t = stepper.time();
  row.advance = V_ * row.t;
  const Lattice& lattice = stepper.sheet().lattice;
  if (lattice.half) complete_symmetric(totals);
  for (int c = 0; c < 3; ++c) {
    row.F[c] = totals[c] * impulse.linear() / history_.interval;
    row.M[c] = totals[c + 3] * impulse.angular() / history_.interval;
  }
  row.broken_bonds = totals[6];
  row.contacts = totals[7] * lattice.copies();
  stepper.timer().lap(Phase::sampling);
  watch_.sample(stepper, row);
  stepper.timer().lap(Phase::energy);
  history_.rows.push_back(row);

  const double fastest = comm_.max(m.fastest);
  if (fastest <= fastest_allowed_ && watch_.surplus() == 0.0) return true;
  reason = describe_failure(stepper, m, fastest);
  return false;
}

// Collective: the rank that holds the runaway particle tells the others about it.
std::string Recorder::describe_failure(const Stepper& stepper, const Motion& m, double fastest) const {
  const int holder = static_cast<int>(comm_.max(m.fastest == fastest ? comm_.rank() : -1.0));
  std::string place;
  if (comm_.rank() == holder) {
    const IceSheet& sheet = stepper.sheet();
    const Layout& layout = sheet.layout;
    const Layout::Place at = layout.place(m.where);
    place = text("the particle first at x = %.3f m, y = %.3f m is the fastest (%.3g m/s); likely cause: ",
                 sheet.lattice.x(layout.i0 + at.il), sheet.lattice.y(layout.j0 + at.jl), fastest) +
            likely_cause(stepper, m.where, dt_limit_);
  }
  place = comm_.broadcast(place, holder);
  const HistoryRow& row = history_.rows.back();
  const std::string words =
      text("unstable at step %lld (t = %.4g s, advance %.4g m): ", static_cast<long long>(stepper.steps()),
           row.t, row.advance);
  if (fastest > fastest_allowed_) return words + "ice moves faster than sound: " + place;
  return words +
         text("the ice has gained %.3g J that nobody gave it (hull's work %.3g J): ", watch_.surplus(),
              row.hull_work) +
         place;
}

}  // namespace icebow
