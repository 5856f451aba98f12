#include "hullgen/cad/spline_surface.h"

#include <Eigen/LU>
#include <algorithm>

namespace icebow {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// Values of the degree + 1 splines that are not zero at t; `first` is the index of the first of them.
// Cox and de Boor's recurrence.
std::vector<double> basis(const std::vector<double>& knots, int degree, double t, int& first) {
  const int last_span = static_cast<int>(knots.size()) - degree - 2;
  const int span = std::min(
      static_cast<int>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin()) - 1, last_span);
  std::vector<double> values{1.0};
  for (int d = 1; d <= degree; ++d) {
    std::vector<double> higher(static_cast<std::size_t>(d) + 1, 0.0);
    for (int k = 0; k < d; ++k) {
      const double left = knots[span + 1 - d + k], right = knots[span + 1 + k];
      const double share = (t - left) / (right - left);
      higher[k] += (1.0 - share) * values[k];
      higher[k + 1] += share * values[k];
    }
    values = higher;
  }
  first = span - degree;
  return values;
}

std::vector<double> greville(const std::vector<double>& knots, int degree) {
  std::vector<double> sites;
  for (std::size_t i = 1; i + degree < knots.size(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < degree; ++k) sum += knots[i + k];
    sites.push_back(sum / degree);
  }
  return sites;
}

Eigen::PartialPivLU<Eigen::MatrixXd> collocation(const std::vector<double>& knots,
                                                 const std::vector<double>& sites) {
  const auto n = static_cast<Eigen::Index>(sites.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index row = 0; row < n; ++row) {
    int first = 0;
    const std::vector<double> values = basis(knots, spline_degree, sites[row], first);
    for (std::size_t k = 0; k < values.size(); ++k)
      matrix(row, first + static_cast<Eigen::Index>(k)) = values[k];
  }
  return matrix.partialPivLu();
}

}  // namespace

std::vector<double> clamped_knots(double start, const std::vector<Interval>& intervals) {
  std::vector<double> knots(spline_degree + 1, start);
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Interval& piece = intervals[i];
    for (int k = 1; k < piece.spans; ++k) knots.push_back(start + (piece.end - start) * k / piece.spans);
    const int multiplicity = i + 1 == intervals.size() ? spline_degree + 1 : piece.multiplicity;
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), piece.end);
    start = piece.end;
  }
  return knots;
}

Vec3 SplineSurface::point(double u, double v) const {
  int u0 = 0, v0 = 0;
  const std::vector<double> a = basis(u_knots, u_degree, u, u0), b = basis(v_knots, v_degree, v, v0);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) sum += a[i] * b[j] * poles[u0 + i][v0 + j];
  return sum;
}

SplineCurve SplineSurface::edge_at_u(bool last) const {
  return {v_degree, v_knots, last ? poles.back() : poles.front()};
}
SplineCurve SplineSurface::edge_at_v(bool last) const {
  SplineCurve edge{u_degree, u_knots, {}};
  for (const auto& row : poles) edge.poles.push_back(last ? row.back() : row.front());
  return edge;
}

SplineSurface fitted_surface(const std::function<Vec3(double, double)>& function,
                             const std::vector<double>& u_knots, const std::vector<double>& v_knots) {
  const std::vector<double> u = greville(u_knots, spline_degree), v = greville(v_knots, spline_degree);
  const auto along_u = collocation(u_knots, u), along_v = collocation(v_knots, v);
  SplineSurface surface;
  surface.u_knots = u_knots;
  surface.v_knots = v_knots;
  surface.poles.assign(u.size(), std::vector<Vec3>(v.size()));
  for (std::size_t i = 0; i < u.size(); ++i) {  // along v first: the rows' poles
    Points row(v.size(), 3);
    for (std::size_t j = 0; j < v.size(); ++j) row.row(j) = function(u[i], v[j]).transpose();
    row = along_v.solve(row).eval();
    for (std::size_t j = 0; j < v.size(); ++j) surface.poles[i][j] = row.row(j).transpose();
  }
  for (std::size_t j = 0; j < v.size(); ++j) {
    Points column(u.size(), 3);
    for (std::size_t i = 0; i < u.size(); ++i) column.row(i) = surface.poles[i][j].transpose();
    column = along_u.solve(column).eval();
    for (std::size_t i = 0; i < u.size(); ++i) surface.poles[i][j] = column.row(i).transpose();
  }
  return surface;
}

SplineSurface ruled_surface(const SplineCurve& from, const SplineCurve& to) {
  SplineSurface surface;
  surface.u_degree = from.degree;
  surface.u_knots = from.knots;
  surface.v_degree = 1;
  surface.v_knots = {0.0, 0.0, 1.0, 1.0};
  for (std::size_t k = 0; k < from.poles.size(); ++k) surface.poles.push_back({from.poles[k], to.poles[k]});
  return surface;
}

SplineCurve straight_line(const Vec3& from, const Vec3& to) {
  return {1, {0.0, 0.0, 1.0, 1.0}, {from, to}};
}

SplineCurve mirrored(SplineCurve curve) {
  for (Vec3& pole : curve.poles) pole.y() = -pole.y();
  return curve;
}
SplineSurface mirrored(SplineSurface surface) {
  for (auto& row : surface.poles)
    for (Vec3& pole : row) pole.y() = -pole.y();
  return surface;
}

}  // namespace icebow
