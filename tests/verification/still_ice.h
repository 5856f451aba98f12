// A piece of ice at rest under given forces: conjugate gradients on the solver's own accelerations, in double
// precision and so close to the undeformed lattice that they are linear.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "base/units.h"
#include "ice_block.h"
#include "solver/energy.h"

namespace icebow {

enum class Surroundings { dry, water };

inline Scenario in_double_precision(Scenario s) {
  s.numerics.precision = Precision::fp64;
  return s;
}

class StillIce {
 public:
  using Where = std::function<bool(int i, int j, int k)>;

  explicit StillIce(const Scenario& s, Surroundings around = Surroundings::dry)
      : ice(in_double_precision(s)), mass_(s.ice.rho * ice.lattice.particle_volume()) {
    ice.for_each([&](int, int, int, std::size_t p) { address_.push_back(p); });
    free_.assign(3 * address_.size(), 1.0);
    force_ = displacement_ = Eigen::VectorXd::Zero(3 * address_.size());
    drift_.dt = 1.0;  // turns accelerations into velocities
    drift_.gravity = around == Surroundings::water ? gravity : 0.0;
    drift_.lift = drift_.gravity * s.water.rho / s.ice.rho;
    drift_.inverse_dx = 1.0 / ice.lattice.dx;
    at_rest_ = accelerations(displacement_, 0.0);
  }

  void hold(const Where& where) {
    for_each([&](int i, int j, int k, std::size_t n) {
      if (where(i, j, k)) std::fill_n(&free_[3 * n], 3, 0.0);
    });
  }
  // Spreads a force [N] evenly over the particles named.
  void push(const Where& where, const Vec3& force) {
    std::vector<std::size_t> pushed;
    for_each([&](int i, int j, int k, std::size_t n) {
      if (where(i, j, k)) pushed.push_back(n);
    });
    for (std::size_t n : pushed) force_.segment<3>(3 * n) += force / double(pushed.size());
  }

  // From where it is; returns the iterations. Ice that nothing holds needs forces in balance.
  int settle(double tolerance = 1e-7) {
    Eigen::VectorXd r = unheld(force_) - stiffness(displacement_), direction = r;
    const double wanted = tolerance * unheld(force_).norm();
    double rr = r.squaredNorm();
    const int limit = 40000;
    int n = 0;
    for (; n < limit && std::sqrt(rr) > wanted; ++n) {
      const Eigen::VectorXd Kd = stiffness(direction);
      const double alpha = rr / direction.dot(Kd);
      displacement_ += alpha * direction;
      r -= alpha * Kd;
      const double next = r.squaredNorm();
      direction = r + (next / rr) * direction;
      rr = next;
    }
    if (n == limit) throw std::runtime_error("still ice: the forces did not balance");
    return n;
  }

  Vec3 u(int i, int j, int k) const { return displacement_.segment<3>(3 * ice.lattice.id(i, j, k)); }
  double work() const { return 0.5 * force_.dot(displacement_); }  // of the forces, put on slowly [J]
  // Elastic energy the solver finds in the displacements, at `scale` times their size [J].
  double elastic_energy(const Scenario& s, double scale) {
    place(displacement_, scale);
    ice.accelerate();
    const EnergyModel model(s, ice.lattice, ice.material, 1e-5);
    return sheet_energy(ice.sheet, model).elastic * model.quantum / (scale * scale);
  }

  IceBlock ice;

 private:
  template <class Visit>
  void for_each(Visit visit) const {
    std::size_t n = 0;
    ice.for_each([&](int i, int j, int k, std::size_t) { visit(i, j, k, n++); });
  }
  Eigen::VectorXd unheld(const Eigen::VectorXd& x) const {
    return x.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(free_.data(), x.size()));
  }
  void place(const Eigen::VectorXd& x, double scale) {
    for (std::size_t n = 0; n < address_.size(); ++n) {
      for (int c = 0; c < 3; ++c) {
        ice.sheet.u[c][address_[n]] = scale * x[3 * n + c];
        ice.sheet.v[c][address_[n]] = 0.0;
      }
    }
  }
  Eigen::VectorXd accelerations(const Eigen::VectorXd& x, double scale) {
    place(x, scale);
    ice.accelerate();
    ice.sheet.drift(drift_);
    Eigen::VectorXd a(x.size());
    for (std::size_t n = 0; n < address_.size(); ++n) {
      for (int c = 0; c < 3; ++c) a[3 * n + c] = ice.sheet.v[c][address_[n]];
    }
    return a;
  }
  // Forces that hold the displacements x. A strain of 1e-7 at most: what is not linear is as small.
  Eigen::VectorXd stiffness(const Eigen::VectorXd& x) {
    const double largest = x.cwiseAbs().maxCoeff();
    if (largest == 0.0) return x;  // nothing to linearise
    const double scale = 1e-7 * ice.lattice.dx / largest;
    return unheld(accelerations(unheld(x), scale) - at_rest_) * (-mass_ / scale);
  }

  double mass_;
  std::vector<std::size_t> address_;
  std::vector<double> free_;
  Eigen::VectorXd force_, displacement_, at_rest_;
  DriftSettings drift_{};
};

}  // namespace icebow
