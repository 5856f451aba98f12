#include "solver/tank/still_ice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/units.h"
#include "solver/ice/energy.h"

namespace icebow {

Scenario in_double_precision(Scenario s) {
  s.numerics.precision = Precision::fp64;
  return s;
}

StillIce::StillIce(const Scenario& s, Surroundings around)
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

template <class Visit>
void StillIce::for_each(Visit visit) const {
  std::size_t n = 0;
  ice.for_each([&](int i, int j, int k, std::size_t) { visit(i, j, k, n++); });
}

void StillIce::hold(const Where& where) {
  for (int axis = 0; axis < 3; ++axis) hold_along(where, axis, 0.0);
}

void StillIce::hold_along(const Where& where, int axis, double displacement) {
  for_each([&](int i, int j, int k, std::size_t n) {
    if (!where(i, j, k)) return;
    free_[3 * n + axis] = 0.0;
    displacement_[3 * n + axis] = displacement;
  });
}

void StillIce::push(const Where& where, const Vec3& force) {
  std::vector<std::size_t> pushed;
  for_each([&](int i, int j, int k, std::size_t n) {
    if (where(i, j, k)) pushed.push_back(n);
  });
  for (std::size_t n : pushed) force_.segment<3>(3 * n) += force / double(pushed.size());
}

int StillIce::settle(double tolerance) {
  const Eigen::VectorXd given = displacement_ - unheld(displacement_);
  const double wanted = tolerance * (unheld(force_).norm() + unheld(stiffness(given)).norm());
  Eigen::VectorXd r = unheld(force_ - stiffness(displacement_)), direction = r;
  double rr = r.squaredNorm();
  const int limit = 40000;
  int n = 0;
  for (; n < limit && std::sqrt(rr) > wanted; ++n) {
    const Eigen::VectorXd Kd = unheld(stiffness(direction));
    const double alpha = rr / direction.dot(Kd);
    displacement_ += alpha * direction;
    r -= alpha * Kd;
    const double next = r.squaredNorm();
    direction = r + (next / rr) * direction;
    rr = next;
  }
  if (n == limit) throw std::runtime_error("still ice: the forces did not balance");
  note_dilatations();
  return n;
}

void StillIce::note_dilatations() {
  dilatation_ = Eigen::VectorXd::Zero(address_.size());
  const double scale = linear_scale(displacement_);
  if (scale == 0.0) return;
  place(displacement_, scale);
  ice.accelerate();
  for (std::size_t n = 0; n < address_.size(); ++n) dilatation_[n] = ice.sheet.theta[address_[n]] / scale;
}

Vec3 StillIce::support(const Where& where) {
  const Eigen::VectorXd inner = stiffness(displacement_) - force_;
  Vec3 sum = Vec3::Zero();
  for_each([&](int i, int j, int k, std::size_t n) {
    if (where(i, j, k)) sum += inner.segment<3>(3 * n);
  });
  return sum;
}

double StillIce::elastic_energy(const Scenario& s, double scale) {
  place(displacement_, scale);
  ice.accelerate();
  const EnergyModel model(s, ice.lattice, ice.material, 1e-5);
  return sheet_energy(ice.sheet, model).elastic * model.quantum / (scale * scale);
}

Eigen::VectorXd StillIce::unheld(const Eigen::VectorXd& x) const {
  return x.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(free_.data(), x.size()));
}

void StillIce::place(const Eigen::VectorXd& x, double scale) {
  for (std::size_t n = 0; n < address_.size(); ++n) {
    for (int c = 0; c < 3; ++c) {
      ice.sheet.u[c][address_[n]] = scale * x[3 * n + c];
      ice.sheet.v[c][address_[n]] = 0.0;
    }
  }
}

Eigen::VectorXd StillIce::accelerations(const Eigen::VectorXd& x, double scale) {
  place(x, scale);
  ice.accelerate();
  ice.sheet.drift(drift_);
  Eigen::VectorXd a(x.size());
  for (std::size_t n = 0; n < address_.size(); ++n) {
    for (int c = 0; c < 3; ++c) a[3 * n + c] = ice.sheet.v[c][address_[n]];
  }
  return a;
}

// A strain of 1e-7 at most: what is not linear is as small. 0 where there is nothing to linearise.
double StillIce::linear_scale(const Eigen::VectorXd& x) const {
  const double largest = x.cwiseAbs().maxCoeff();
  return largest == 0.0 ? 0.0 : 1e-7 * ice.lattice.dx / largest;
}

// Forces that hold the displacements x.
Eigen::VectorXd StillIce::stiffness(const Eigen::VectorXd& x) {
  const double scale = linear_scale(x);
  if (scale == 0.0) return x;
  return (accelerations(x, scale) - at_rest_) * (-mass_ / scale);
}

}  // namespace icebow
