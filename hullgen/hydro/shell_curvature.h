// How much of a hull's shell is plate that bends one way: flat, single-curved or curved both ways.
#pragma once

#include <vector>

#include "geometry/quad_mesh.h"

namespace icebow {

// Principal curvatures at a panel's middle, the larger one by amount first [1/m]; NaN where the panel has too
// few neighbours to tell.
struct PanelCurvature {
  double larger, smaller;
};

// Of each panel, from the quadratic height function (least squares) over its plane through the corners of the
// panels around it, two rings of them, that are reached without crossing a knuckle: of the limits 25, 12, 6,
// 3 and 1.5 deg between panels the widest whose fit leaves 0.3 % of the neighbourhood or less. Exact for
// cylinders and cones to second order in the panel's size.
std::vector<PanelCurvature> panel_curvatures(const QuadMesh& mesh);

// Shares of an area, by panels. A direction in which the radius of curvature is `straight` or more counts as
// straight.
struct ShellShares {
  double area = 0.0;                                            //!< [m^2]
  double flat = 0.0, single_curved = 0.0, double_curved = 0.0;  // together 1; 0 where there is no such shell
};

// The forebody's wetted shell: panels whose middle lies below z = 0 and ahead of x = aft_end [m]. Of more
// than 40,000 of them every n-th is looked at.
ShellShares shell_shares(const QuadMesh& mesh, double aft_end, double straight);

}  // namespace icebow
