// A free piece in motion, and the times at which a signal of it changes sign.
#pragma once

#include <vector>

#include "solver/lattice/stability.h"
#include "tests/support/ice_block.h"

namespace icebow {

// Steps a free piece and calls `watch(time)` after each step until it returns false.
class Motion {
 public:
  Motion(IceBlock& ice, const Scenario& s, double g) : ice_(ice) {
    dt_ = 0.8 * stable_time_step(ice.sheet.stencil, ice.material, ice.lattice.dx, s.ice.rho,
                                 s.numerics.surface_correction);
    drift_.dt = dt_;
    drift_.gravity = g;
    drift_.lift = g * s.water.rho / s.ice.rho;
    drift_.inverse_dx = 1.0 / ice.lattice.dx;
  }
  template <class Watch>
  void run(double end, Watch watch) {
    for (double t = dt_; t < end; t += dt_) {
      ice_.sheet.drift(drift_);
      ice_.sheet.dilatation();
      ice_.sheet.force();
      if (!watch(t)) return;
    }
  }

 private:
  IceBlock& ice_;
  DriftSettings drift_{};
  double dt_;
};

// Times of a signal's sign changes, interpolated.
class Crossings {
 public:
  explicit Crossings(std::size_t wanted = 3) : wanted_(wanted) {}
  // False once it has seen as many as wanted.
  bool add(double t, double value) {
    if (previous_ * value < 0.0) times_.push_back(t - (t - t_) * value / (value - previous_));
    previous_ = value;
    t_ = t;
    return times_.size() < wanted_;
  }
  // From the first to the last crossing; 0 if too few were seen.
  double period() const {
    if (times_.size() < wanted_) return 0.0;
    return 2.0 * (times_.back() - times_.front()) / double(wanted_ - 1);
  }

 private:
  std::size_t wanted_;
  double previous_ = 0.0, t_ = 0.0;
  std::vector<double> times_;
};

inline double mean_displacement(const IceBlock& ice, int component) {
  double sum = 0.0;
  ice.for_each([&](int, int, int, std::size_t p) { sum += ice.sheet.u[component][p]; });
  return sum / double(ice.lattice.particles());
}

}  // namespace icebow
