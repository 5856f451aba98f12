// A piece of ice at rest under given forces or displacements: conjugate gradients on the solver's own
// accelerations, in double precision and so close to the undeformed lattice that they are linear. One rank.
#pragma once

#include <functional>
#include <vector>

#include "solver/ice/ice_block.h"

namespace icebow {

enum class Surroundings { dry, water };

Scenario in_double_precision(Scenario s);

class StillIce {
 public:
  using Where = std::function<bool(int i, int j, int k)>;

  explicit StillIce(const Scenario& s, Surroundings around = Surroundings::dry);

  void hold(const Where& where);
  // Holds along one axis (0, 1, 2) alone, displaced by so much [m].
  void hold_along(const Where& where, int axis, double displacement);
  // Spreads a force [N] evenly over the particles named.
  void push(const Where& where, const Vec3& force);

  // From where it is; returns the iterations. Ice that nothing holds needs forces in balance. `tolerance` is
  // the largest unbalanced force, over that of the forces and displacements given. Throws std::runtime_error
  // where they do not balance.
  int settle(double tolerance = 1e-7);

  // Dilatation at what settle() found. j < 0: the mirror image of a half model's column.
  double theta(int i, int j, int k) const { return dilatation_[ice.lattice.id(i, own(j), k)]; }
  Vec3 u(int i, int j, int k) const {
    const Vec3 of_own = displacement_.segment<3>(3 * ice.lattice.id(i, own(j), k));
    return j < 0 ? Vec3(of_own.x(), -of_own.y(), of_own.z()) : of_own;
  }
  double work() const { return 0.5 * force_.dot(displacement_); }  // of the forces, put on slowly [J]
  // Force by which the particles named are kept where they are, a half model's images not counted [N].
  Vec3 support(const Where& where);
  // Elastic energy the solver finds in the displacements, at `scale` times their size [J].
  double elastic_energy(const Scenario& s, double scale);

  IceBlock ice;

 private:
  template <class Visit>
  void for_each(Visit visit) const;
  static int own(int j) { return j < 0 ? -1 - j : j; }
  Eigen::VectorXd unheld(const Eigen::VectorXd& x) const;
  void place(const Eigen::VectorXd& x, double scale);
  Eigen::VectorXd accelerations(const Eigen::VectorXd& x, double scale);
  Eigen::VectorXd stiffness(const Eigen::VectorXd& x);
  double linear_scale(const Eigen::VectorXd& x) const;
  void note_dilatations();

  double mass_;
  std::vector<std::size_t> address_;
  std::vector<double> free_;
  Eigen::VectorXd force_, displacement_, at_rest_, dilatation_;
  DriftSettings drift_{};
};

}  // namespace icebow
