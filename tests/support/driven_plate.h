// A thin plate afloat whose edge x = 0 is met by a hull that comes down at constant speed: its motion by
// Newmark's rule of constant mean acceleration, the contact plastic, until the upper face is at its strength.
//
// Source of the rule: Newmark, J. Eng. Mech. 85 (1959), EM3, 67. Loads and deflections are of the part on the
// mesh.
#pragma once

#include <functional>

#include "tests/support/plate_elements.h"

namespace icebow {

struct Drive {
  double speed = 0.0;     //!< of the hull's face, downwards at the edge [m/s]
  double strength = 0.0;  //!< flexural [Pa]
  // Force downwards by the depth that the face has cut, measured upwards from the edge [N]; it grows with
  // depth and falls at once where depth does.
  std::function<double(double)> contact;
  double ahead = 0.0;      // of the force, over its part downwards
  double arm = 0.0;        //!< its height above the middle of the plate [m]
  double freeboard = 0.0;  //!< further down water lifts no more [m]; 0 = it always does
  bool splits = false;     // along y = 0, where the lower face is at its strength: a mirror edge comes free
  // Stress in the plane at x, y by a force of 1 N ahead.
  std::function<FaceStress(double, double)> in_plane;
};

struct DrivenBreak {
  double peak = 0.0;   //!< highest force downwards until the break [N]
  double at = 0.0;     //!< of the break from the patch that is pressed [m]
  double down = 0.0;   //!< that the face has come since it met the edge [m]
  double first = 0.0;  //!< force at which the lower face was at its strength at y = 0 [N]; 0 = it was not
};

// Throws std::runtime_error where nothing breaks until the face is 3 h down.
DrivenBreak drive(const PlateElements& plate, const LoadedPatch& patch, const Drive& drive);

// Of an elastic half plane x > 0 by 1 N along x on the part -half_width to half_width of its edge (Flamant).
FaceStress pressed_half_plane(double half_width, double h, double x, double y);

}  // namespace icebow
