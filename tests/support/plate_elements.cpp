#include "tests/support/plate_elements.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/units.h"

namespace icebow {
namespace {

using Row = Eigen::Matrix<double, 1, 12>;
using Square = Eigen::Matrix<double, 12, 12>;

constexpr int powers[12][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2},
                               {3, 0}, {2, 1}, {1, 2}, {0, 3}, {3, 1}, {1, 3}};
constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Gauss, four points on 0..1: exact to degree 7.
constexpr double gauss_at[4] = {0.0694318442029737, 0.330009478207572, 0.669990521792428, 0.930568155797026},
                 gauss_weight[4] = {0.173927422568727, 0.326072577431273, 0.326072577431273,
                                    0.173927422568727};

double derivative(double s, int power, int order) {
  double factor = 1.0;
  for (int n = 0; n < order; ++n) factor *= power - n;
  return power < order ? 0.0 : factor * std::pow(s, power - order);
}

Row terms(double s, double t, int along_s, int along_t) {
  Row row;
  for (int n = 0; n < 12; ++n)
    row[n] = derivative(s, powers[n][0], along_s) * derivative(t, powers[n][1], along_t);
  return row;
}

// Coefficients of the polynomial on the unit square by w, dw/ds, dw/dt of its corners.
const Square& coefficients() {
  static const Square found = [] {
    Square values;
    for (int c = 0; c < 4; ++c) {
      const double s = corners[c][0], t = corners[c][1];
      values.row(3 * c) = terms(s, t, 0, 0);
      values.row(3 * c + 1) = terms(s, t, 1, 0);
      values.row(3 * c + 2) = terms(s, t, 0, 1);
    }
    return Square(values.inverse());
  }();
  return found;
}

// One element of a x b.
struct Element {
  double a, b;

  // A derivative of w at s, t of the unit square, by the unknowns.
  Row shape(double s, double t, int along_x, int along_y) const {
    Row row = terms(s, t, along_x, along_y) * coefficients();
    for (int c = 0; c < 4; ++c) row[3 * c + 1] *= a, row[3 * c + 2] *= b;
    return row / (std::pow(a, along_x) * std::pow(b, along_y));
  }
  void matrices(const ThinPlate& plate, Square& bending, Square& cover) const {
    Eigen::Matrix3d law;
    law << 1.0, plate.nu, 0.0, plate.nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - plate.nu);
    bending.setZero();
    cover.setZero();
    for (int p = 0; p < 4; ++p) {
      for (int q = 0; q < 4; ++q) {
        const double s = gauss_at[p], t = gauss_at[q], dA = a * b * gauss_weight[p] * gauss_weight[q];
        Eigen::Matrix<double, 3, 12> curvature;
        curvature << shape(s, t, 2, 0), shape(s, t, 0, 2), 2.0 * shape(s, t, 1, 1);
        const Row w = shape(s, t, 0, 0);
        bending += plate.bending * dA * curvature.transpose() * law * curvature;
        cover += dA * w.transpose() * w;
      }
    }
  }
};

void hold_node(std::vector<char>& free, int w, PlateEdge edge, int turn) {
  if (edge == PlateEdge::clamped) free[w] = free[w + 1] = free[w + 2] = 0;
  if (edge == PlateEdge::mirror) free[w + turn] = 0;
}

}  // namespace

double ThinPlate::characteristic_length() const {
  return std::pow(bending / foundation, 0.25);
}

ThinPlate thin_plate(double E, double nu, double h, double rho, double rho_w, double added_mass) {
  return {E * h * h * h / (12.0 * (1.0 - nu * nu)), nu, h, rho_w * gravity, rho * h + rho_w * added_mass};
}

std::vector<double> graded_lines(double step, double fine_until, double end) {
  std::vector<double> lines = {0.0};
  while (lines.back() < end) {
    const double last = lines.back();
    if (last > fine_until) step *= 7.0 / 6.0;
    lines.push_back(last + 1.5 * step > end ? end : last + step);
  }
  return lines;
}

double FaceStress::largest() const {
  return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
}

double FaceStress::smallest() const {
  return 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
}

FreePart::FreePart(const Eigen::SparseMatrix<double>& matrix, const std::vector<char>& free)
    : place_(free.size(), -1) {
  int n = 0;
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i]) place_[i] = n++;
  std::vector<Eigen::Triplet<double>> entries;
  for (int col = 0; col < matrix.outerSize(); ++col) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, col); it; ++it) {
      if (place_[it.row()] >= 0 && place_[col] >= 0)
        entries.emplace_back(place_[it.row()], place_[col], it.value());
    }
  }
  Eigen::SparseMatrix<double> part(n, n);
  part.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(part);
  if (factor_.info() != Eigen::Success) throw std::runtime_error("plate elements: nothing holds the plate");
}

Eigen::VectorXd FreePart::solve(const Eigen::VectorXd& force) const {
  Eigen::VectorXd part(factor_.rows()), all = Eigen::VectorXd::Zero(force.size());
  for (std::size_t i = 0; i < place_.size(); ++i)
    if (place_[i] >= 0) part[place_[i]] = force[i];
  part = factor_.solve(part);
  for (std::size_t i = 0; i < place_.size(); ++i)
    if (place_[i] >= 0) all[i] = part[place_[i]];
  return all;
}

PlateElements::PlateElements(const ThinPlate& plate, const PlateMesh& mesh) : plate_(plate), mesh_(mesh) {
  assemble();
  note_faces();
  hold();
}

void PlateElements::assemble() {
  const int n = 3 * nx() * ny();
  std::vector<Eigen::Triplet<double>> stiff, cover;
  Square bending, area;
  for (int ix = 0; ix + 1 < nx(); ++ix) {
    for (int iy = 0; iy + 1 < ny(); ++iy) {
      Element{mesh_.x[ix + 1] - mesh_.x[ix], mesh_.y[iy + 1] - mesh_.y[iy]}.matrices(plate_, bending, area);
      std::array<int, 12> at{};
      for (int m = 0; m < 12; ++m) at[m] = unknown(ix + corners[m / 3][0], iy + corners[m / 3][1]) + m % 3;
      for (int r = 0; r < 12; ++r) {
        for (int c = 0; c < 12; ++c) {
          stiff.emplace_back(at[r], at[c], bending(r, c) + plate_.foundation * area(r, c));
          cover.emplace_back(at[r], at[c], area(r, c));
        }
      }
    }
  }
  stiffness_.resize(n, n);
  stiffness_.setFromTriplets(stiff.begin(), stiff.end());
  cover_.resize(n, n);
  cover_.setFromTriplets(cover.begin(), cover.end());
}

void PlateElements::hold() {
  free_.assign(3 * nx() * ny(), 1);
  for (int ix = 0; ix < nx(); ++ix) {
    hold_node(free_, unknown(ix, 0), mesh_.at_y0, 2);
    hold_node(free_, unknown(ix, ny() - 1), mesh_.at_y1, 2);
  }
  for (int iy = 0; iy < ny(); ++iy) {
    hold_node(free_, unknown(0, iy), mesh_.at_x0, 1);
    hold_node(free_, unknown(nx() - 1, iy), mesh_.at_x1, 1);
  }
}

Eigen::VectorXd PlateElements::pressed(const LoadedPatch& patch) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(free_.size());
  double area = 0.0;
  for (int ix = 0; ix + 1 < nx(); ++ix) {
    for (int iy = 0; iy + 1 < ny(); ++iy) {
      const double x0 = mesh_.x[ix], y0 = mesh_.y[iy];
      const Element e{mesh_.x[ix + 1] - x0, mesh_.y[iy + 1] - y0};
      const double xa = std::max(x0, patch.x0), xb = std::min(x0 + e.a, patch.x1),
                   ya = std::max(y0, patch.y0), yb = std::min(y0 + e.b, patch.y1);
      if (xb <= xa || yb <= ya) continue;
      for (int p = 0; p < 16; ++p) {
        const double x = xa + (xb - xa) * gauss_at[p / 4], y = ya + (yb - ya) * gauss_at[p % 4],
                     dA = (xb - xa) * (yb - ya) * gauss_weight[p / 4] * gauss_weight[p % 4];
        const Row w = e.shape((x - x0) / e.a, (y - y0) / e.b, 0, 0);
        for (int m = 0; m < 12; ++m)
          force[unknown(ix + corners[m / 3][0], iy + corners[m / 3][1]) + m % 3] -= dA * w[m];
        area += dA;
      }
    }
  }
  return force / area;
}

Eigen::VectorXd PlateElements::turned(double y0, double y1) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(free_.size());
  double length = 0.0;
  const double a = mesh_.x[1] - mesh_.x[0];
  for (int iy = 0; iy + 1 < ny(); ++iy) {
    const Element e{a, mesh_.y[iy + 1] - mesh_.y[iy]};
    const double ya = std::max(mesh_.y[iy], y0), yb = std::min(mesh_.y[iy] + e.b, y1);
    for (int p = 0; p < 4 && yb > ya; ++p) {
      const double y = ya + (yb - ya) * gauss_at[p], dy = (yb - ya) * gauss_weight[p];
      const Row slope = e.shape(0.0, (y - mesh_.y[iy]) / e.b, 1, 0);  // u = -z dw/dx
      for (int m = 0; m < 12; ++m)
        force[unknown(corners[m / 3][0], iy + corners[m / 3][1]) + m % 3] -= dy * slope[m];
      length += dy;
    }
  }
  return force / length;
}

Eigen::VectorXd PlateElements::settle(const Eigen::VectorXd& force) const {
  return FreePart(stiffness_, free_).solve(force);
}

// Strain -z d2w/dx2 at z = h/2.
void PlateElements::note_faces() {
  const double factor = -6.0 * plate_.bending / (plate_.h * plate_.h);
  std::vector<Eigen::Triplet<double>> entries;
  for (int ix = 0; ix < nx(); ++ix) {
    for (int iy = 0; iy < ny(); ++iy) {
      const int x0 = std::max(0, ix - 1), x1 = std::min(ix, nx() - 2), y0 = std::max(0, iy - 1),
                y1 = std::min(iy, ny() - 2), row = 3 * (ix * ny() + iy);
      const double share = factor / ((x1 - x0 + 1) * (y1 - y0 + 1));
      for (int e = 0; e < (x1 - x0 + 1) * (y1 - y0 + 1); ++e) {
        const int ex = x0 + e % (x1 - x0 + 1), ey = y0 + e / (x1 - x0 + 1);
        const Element of{mesh_.x[ex + 1] - mesh_.x[ex], mesh_.y[ey + 1] - mesh_.y[ey]};
        const Row xx = of.shape(ix - ex, iy - ey, 2, 0), yy = of.shape(ix - ex, iy - ey, 0, 2),
                  xy = of.shape(ix - ex, iy - ey, 1, 1);
        for (int m = 0; m < 12; ++m) {
          const int at = unknown(ex + corners[m / 3][0], ey + corners[m / 3][1]) + m % 3;
          entries.emplace_back(row, at, share * (xx[m] + plate_.nu * yy[m]));
          entries.emplace_back(row + 1, at, share * (yy[m] + plate_.nu * xx[m]));
          entries.emplace_back(row + 2, at, share * (1.0 - plate_.nu) * xy[m]);
        }
      }
    }
  }
  faces_.resize(3 * nx() * ny(), 3 * nx() * ny());
  faces_.setFromTriplets(entries.begin(), entries.end());
}

FaceStress PlateElements::upper_face(const Eigen::VectorXd& u, int ix, int iy) const {
  const int row = 3 * (ix * ny() + iy);
  return {faces_.row(row).dot(u), faces_.row(row + 1).dot(u), faces_.row(row + 2).dot(u)};
}

std::vector<FaceStress> PlateElements::upper_face(const Eigen::VectorXd& u) const {
  const Eigen::VectorXd all = faces_ * u;
  std::vector<FaceStress> faces;
  for (int n = 0; n < nx() * ny(); ++n) faces.push_back({all[3 * n], all[3 * n + 1], all[3 * n + 2]});
  return faces;
}

}  // namespace icebow
