#include "tests/support/driven_plate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "base/units.h"

namespace icebow {
namespace {

class DrivenPlate {
 public:
  DrivenPlate(const PlateElements& plate, const LoadedPatch& patch, const Drive& drive)
      : plate_(plate),
        patch_(patch),
        drive_(drive),
        dt_(0.002 * plate.plate().h / drive.speed),
        free_(plate.free()),
        load_(plate.pressed(patch) + drive.ahead * drive.arm * plate.turned(patch.y0, patch.y1)),
        u_(Eigen::VectorXd::Zero(load_.size())),
        v_(u_),
        a_(u_) {
    find_areas();
    factor();
  }

  bool broken() const { return found_.at > 0.0; }
  const DrivenBreak& found() const { return found_; }

  void step() {
    move();
    const std::vector<FaceStress> bending = plate_.upper_face(u_);
    if (look_below(bending)) factor();
    look_above(bending);
    if (found_.down > 3.0 * plate_.plate().h) throw std::runtime_error("driven plate: nothing breaks");
  }

 private:
  void find_areas() {
    const auto& mesh = plate_.mesh();
    const double x1 = mesh.x.back(), y1 = mesh.y.back();
    areas_ = -x1 * y1 * plate_.pressed({0.0, x1, 0.0, y1});
  }
  void factor() {
    const Eigen::SparseMatrix<double> matrix =
        plate_.stiffness() + (4.0 * plate_.plate().mass / (dt_ * dt_)) * plate_.cover();
    part_ = std::make_unique<FreePart>(matrix, free_);
    by_load_ = part_->solve(load_);
    compliance_ = load_.dot(by_load_);
  }
  // What the water lifts less than the foundation does.
  Eigen::VectorXd flooded() const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(u_.size());
    if (drive_.freeboard == 0.0) return force;
    for (Eigen::Index n = 0; n < u_.size(); n += 3)
      force[n] = -plate_.plate().foundation * areas_[n] * std::max(0.0, -u_[n] - drive_.freeboard);
    return force;
  }
  // Of the hull, which is `above` deep in the edge without it.
  double contact_force(double above) {
    double low = 0.0, high = std::max(0.0, above) / compliance_;
    for (int n = 0; n < 60; ++n) {
      const double force = 0.5 * (low + high);
      (drive_.contact(above - compliance_ * force) > force ? low : high) = force;
    }
    const double depth = above - compliance_ * low;
    if (depth >= cut_) {
      cut_ = std::max(depth, 0.0);
      return low;
    }
    return std::clamp((above - cut_) / compliance_, 0.0, drive_.contact(cut_));
  }
  void move() {
    time_ += dt_;
    const Eigen::VectorXd carried = (4.0 / (dt_ * dt_)) * u_ + (4.0 / dt_) * v_ + a_;
    Eigen::VectorXd next = part_->solve(plate_.plate().mass * (plate_.cover() * carried) + flooded());
    force_ = contact_force(drive_.speed * time_ - load_.dot(next));
    next += force_ * by_load_;
    const Eigen::VectorXd a = (4.0 / (dt_ * dt_)) * (next - u_) - (4.0 / dt_) * v_ - a_;
    v_ += 0.5 * dt_ * (a_ + a);
    a_ = a;
    u_ = next;
    found_.peak = std::max(found_.peak, force_);
    found_.down = drive_.speed * time_;
  }
  FaceStress face(const FaceStress& bending, double x, double y, double sign) const {
    const FaceStress plane = drive_.in_plane ? drive_.in_plane(x, y) : FaceStress();
    const double ahead = drive_.ahead * force_;
    return {sign * bending.xx + ahead * plane.xx, sign * bending.yy + ahead * plane.yy,
            sign * bending.xy + ahead * plane.xy};
  }
  // Whether a split has run on.
  bool look_below(const std::vector<FaceStress>& bending) {
    bool ran = false;
    for (int ix = 0; ix < plate_.nx(); ++ix) {
      if (face(bending[ix * plate_.ny()], plate_.mesh().x[ix], 0.0, -1.0).yy < drive_.strength) continue;
      if (found_.first == 0.0) found_.first = force_;
      char& turns = free_[plate_.unknown(ix, 0) + 2];
      if (!drive_.splits || turns) continue;
      turns = 1;
      ran = true;
    }
    return ran;
  }
  // Stress away from the patch, within 60 degrees of the normal, or on it where nothing splits. Beside a
  // split Kirchhoff's twisting moments have no bound, and are left out thus.
  void look_above(const std::vector<FaceStress>& bending) {
    double highest = drive_.strength;
    for (int ix = 0; ix < plate_.nx(); ++ix) {
      const double x = plate_.mesh().x[ix];
      if (x < 1.5 * plate_.plate().h) continue;
      for (int iy = 0; iy < (drive_.splits ? plate_.ny() : 1); ++iy) {
        const double aside = std::max(0.0, plate_.mesh().y[iy] - patch_.y1);
        if (aside > std::sqrt(3.0) * x) break;
        const double away = std::atan2(aside, x), c = std::cos(away), d = std::sin(away);
        const FaceStress f = face(bending[ix * plate_.ny() + iy], x, plate_.mesh().y[iy], 1.0);
        const double stress = c * c * f.xx + 2.0 * c * d * f.xy + d * d * f.yy;
        if (stress < highest) continue;
        highest = stress;
        found_.at = std::hypot(x, aside);
      }
    }
  }

  const PlateElements& plate_;
  LoadedPatch patch_;
  const Drive& drive_;
  double dt_, time_ = 0.0, force_ = 0.0, cut_ = 0.0, compliance_ = 0.0;
  std::vector<char> free_;
  Eigen::VectorXd load_, u_, v_, a_, areas_, by_load_;
  std::unique_ptr<FreePart> part_;
  DrivenBreak found_;
};

}  // namespace

DrivenBreak drive(const PlateElements& plate, const LoadedPatch& patch, const Drive& drive) {
  DrivenPlate driven(plate, patch, drive);
  while (!driven.broken()) driven.step();
  return driven.found();
}

FaceStress pressed_half_plane(double a, double h, double x, double y) {
  const double one = std::atan2(y + a, x), two = std::atan2(y - a, x), p = 1.0 / (2.0 * a * h * pi);
  const double turn = one - two, spread = 0.5 * (std::sin(2.0 * one) - std::sin(2.0 * two));
  return {-p * (turn + spread), -p * (turn - spread), 0.5 * p * (std::cos(2.0 * one) - std::cos(2.0 * two))};
}

}  // namespace icebow
