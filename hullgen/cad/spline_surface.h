// B-spline curves and surfaces, and their fit to a surface that is given as a function.
//
// A knot vector is clamped: its ends stand degree + 1 times in it. An inner knot of multiplicity m leaves the
// spline degree - m times continuously differentiable there.
#pragma once

#include <functional>
#include <vector>

#include "base/vec.h"

namespace icebow {

constexpr int spline_degree = 4;

struct SplineCurve {
  int degree = 1;
  std::vector<double> knots;
  std::vector<Vec3> poles;
};

struct SplineSurface {
  std::vector<double> u_knots, v_knots;  // of the degrees below
  int u_degree = spline_degree, v_degree = spline_degree;
  std::vector<std::vector<Vec3>> poles;  // [u][v]

  Vec3 point(double u, double v) const;
  SplineCurve edge_at_u(bool last) const;  // along v, at the first or last u
  SplineCurve edge_at_v(bool last) const;  // along u, at the first or last v
};

// A piece of a direction over which the function is smooth.
struct Interval {
  double end;        // from the end of the one before
  int spans;         // equal pieces
  int multiplicity;  // of the knot at its end, where that is an inner one
};

// Clamped knots of the degree 4 from `start` through the intervals.
std::vector<double> clamped_knots(double start, const std::vector<Interval>& intervals);

// The spline of degree 4 in both directions that has the function's values at the Greville abscissae (de
// Boor, A Practical Guide to Splines, chapter XIII): piecewise polynomials of degree 4 with these breaks are
// reproduced to round-off. The edge of a patch depends on the function's values on that edge alone, so
// patches that share knots there share the edge.
SplineSurface fitted_surface(const std::function<Vec3(double u, double v)>& function,
                             const std::vector<double>& u_knots, const std::vector<double>& v_knots);

// Straight from each point of one curve to that of the other, which has the same knots: u along them, v
// across.
SplineSurface ruled_surface(const SplineCurve& from, const SplineCurve& to);

SplineCurve straight_line(const Vec3& from, const Vec3& to);
// Mirror images in the plane y = 0.
SplineCurve mirrored(SplineCurve curve);
SplineSurface mirrored(SplineSurface surface);

}  // namespace icebow
