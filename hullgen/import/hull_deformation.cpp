#include "hullgen/import/hull_deformation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/text.h"
#include "base/units.h"
#include "hullgen/bow/bow_angles.h"
#include "hullgen/bow/dimensions.h"
#include "hullgen/mesh/mesh_check.h"

namespace icebow {
namespace {

constexpr int controls = 9;             // D_jk, k fastest
constexpr double least_stretch = 0.05;  // of 1 + d(dx)/dx: at 0 the hull folds
using Controls = Eigen::Matrix<double, controls, 1>;
// Cotangents of stem, waterline, buttock and the waterline at B/4, and x of the stem in beams.
using Slopes = Eigen::Matrix<double, 5, 1>;

class DeformationBox {
 public:
  explicit DeformationBox(const ImportedHull& hull) {
    const Box box = bounding_box(hull.mesh);
    aft_ = -std::min(deformation_reach * hull.Lf, 0.9 * hull.L);
    length_ = box.upper.x() - aft_;
    half_breadth_ = box.upper.y();
    keel_ = box.lower.z();
    depth_ = box.upper.z() - keel_;
  }

  // dx of a point for each control.
  Controls weights(const Vec3& p) const {
    const double s = std::max(0.0, (p.x() - aft_) / length_);
    return s * s * (3.0 - 2.0 * s) * across(p);  // B_2^3 + B_3^3
  }
  // d(dx)/dx for each control.
  Controls slopes(const Vec3& p) const {
    const double s = std::max(0.0, (p.x() - aft_) / length_);
    return 6.0 * s * (1.0 - s) / length_ * across(p);
  }

 private:
  static Vec3 bernstein(double t) { return {(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t}; }
  Controls across(const Vec3& p) const {
    const Vec3 t = bernstein(std::min(1.0, std::abs(p.y()) / half_breadth_));
    const Vec3 u = bernstein((p.z() - keel_) / depth_);
    Controls w;
    for (int k = 0; k < controls; ++k) w[k] = t[k / 3] * u[k % 3];
    return w;
  }

  double aft_, length_, half_breadth_, keel_, depth_;
};

QuadMesh moved(const QuadMesh& mesh, const DeformationBox& box, const Controls& d) {
  QuadMesh result = mesh;
  for (Vec3& p : result.points) p.x() += box.weights(p).dot(d);
  return result;
}

double cot(double angle) {
  return std::cos(angle) / std::sin(angle);
}

Slopes slopes_of(const BowAngles& a, double stem_in_beams) {
  Slopes s;
  s << cot(a.stem), cot(a.waterline), cot(a.buttock), cot(a.buttock) * cot(a.flare), stem_in_beams;
  return s;
}

Slopes slopes_of(const QuadMesh& mesh, const std::vector<int>& on_chords) {
  const HullMeasurement m = measure_hull(mesh, on_chords);
  return slopes_of(m.angles, m.P0.x() / m.beam);
}

// Newton's method; the slopes are linear in the controls as long as the same points are asked, so it ends
// soon.
Controls solved(const ImportedHull& hull, const DeformationBox& box, const BowAngles& asked) {
  const double unit = 0.01 * hull.B;
  const Slopes wanted = slopes_of(asked, 0.0), before = slopes_of(hull.mesh, hull.on_chords);
  Eigen::Matrix<double, 5, controls> gradient;
  for (int k = 0; k < controls; ++k)
    gradient.col(k) =
        (slopes_of(moved(hull.mesh, box, unit * Controls::Unit(k)), hull.on_chords) - before) / unit;
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse{Eigen::MatrixXd(gradient)};
  Controls d = inverse.solve(wanted - before);
  for (int step = 0; step < 6; ++step) {
    const Slopes off = wanted - slopes_of(moved(hull.mesh, box, d), hull.on_chords);
    if (!off.allFinite() || off.cwiseAbs().maxCoeff() < 1e-9) break;
    d += inverse.solve(off);
  }
  return d;
}

struct Fold {
  double stretch = 1.0;
  Vec3 at = Vec3::Zero();
};
Fold narrowest(const QuadMesh& mesh, const DeformationBox& box, const Controls& d) {
  Fold fold;
  for (const Vec3& p : mesh.points) {
    const double stretch = 1.0 + box.slopes(p).dot(d);
    if (stretch < fold.stretch) fold = {stretch, p};
  }
  return fold;
}

std::string in_degrees(const BowAngles& a) {
  return text("stem %.2f, waterline %.2f, buttock %.2f, flare %.2f deg", degrees(a.stem),
              degrees(a.waterline), degrees(a.buttock), degrees(a.flare));
}

Hull refused(const ImportedHull& imported, const BowAngles& asked, const std::string& why) {
  Hull hull = as_hull(imported);
  hull.mesh = QuadMesh();
  hull.requested = asked;
  hull.status = HullStatus::infeasible;
  hull.feasibility.feasible = false;
  hull.reason = "the bow of " + imported.file + " cannot be deformed to " + in_degrees(asked) + ": " + why +
                "; ask for angles nearer to those it has, " + in_degrees(imported.measured.angles);
  return hull;
}

Hull measured(const ImportedHull& imported, const QuadMesh& mesh, const BowAngles& asked) {
  Hull hull = as_hull(imported);
  const HullMeasurement m = measure_hull(mesh, imported.on_chords);
  hull.requested = asked;
  hull.mesh = mesh;
  hull.measured = m.angles;
  hull.waterline_at_quarter_beam = m.waterline_at_quarter_beam;
  hull.flare_at_stem = m.flare_at_stem;
  hull.form += ", bow deformed";
  hull.reason = angle_mismatch(asked, m.angles);
  if (hull.reason.empty()) hull.reason = check_mesh(mesh).reason();
  if (hull.reason.empty()) return hull;
  hull.status = HullStatus::mesh_rejected;
  hull.mesh = QuadMesh();
  return hull;
}

}  // namespace

Hull deformed(const ImportedHull& imported, const BowAngles& asked) {
  const AngleRange range = angle_range(asked);
  if (range.margin < 0.0) return refused(imported, asked, range.sentence);
  const DeformationBox box(imported);
  const Controls d = solved(imported, box, asked);
  if (!d.allFinite()) return refused(imported, asked, "no angles could be read from the deformed mesh");
  const Fold fold = narrowest(imported.mesh, box, d);
  if (fold.stretch < least_stretch)
    return refused(
        imported, asked,
        text("it would fold near (%.3g, %.3g, %.3g) m, where lengths shrink to %.3g of what they were",
             fold.at.x(), fold.at.y(), fold.at.z(), fold.stretch));
  return measured(imported, moved(imported.mesh, box, d), asked);
}

}  // namespace icebow
