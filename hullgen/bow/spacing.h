// Grid lines along a curve, at a wanted spacing that may vary.
#pragma once

#include <functional>
#include <vector>

#include "base/vec.h"

namespace icebow {

using Curve = std::function<Vec3(double parameter)>;
// Wanted cell length [m] at a parameter that lies this arc length [m] from the start.
using CellLength = std::function<double(double parameter, double length)>;

// Parameters from u0 to u1, both included, that cut the curve into at least min_cells cells of the wanted
// length. The curve may stand vertical over its parameter at either end.
std::vector<double> graded(const Curve& curve, double u0, double u1, const CellLength& cell, int min_cells);

// Radius of curvature [m] at u in [u0, u1], from differences over a thousandth of the range; infinite where
// the curve is straight.
double curvature_radius(const Curve& curve, double u0, double u1, double u);

}  // namespace icebow
