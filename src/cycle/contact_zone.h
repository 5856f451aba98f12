// One stretch of the ice's edge that the hull presses down together: its load and how far it has gone down.
// docs/cycle.md, (C1) to (C5).
#pragma once

#include <vector>

#include "cycle/cycle_input.h"
#include "cycle/ice_strip.h"
#include "cycle/strips.h"

namespace icebow::cycle {

// An edge that the hull has reached: the interval of a strip, and what becomes of it in this step.
struct Touch {
  int strip = 0;
  std::size_t interval = 0;
  double deflection_before = 0.0;  //!< of the edge in the step before [m]
  // At the deflection found:
  bool presses = false;
  double depth = 0.0;  //!< how far the hull has come into the edge [m]
  double bare = 0.0;   //!< where the hull is at the lowest place it touches: ice before it is crushed [m]
  Vec3 area = Vec3::Zero();   //!< vector area of the contact, out of the hull [m^2]
  double normal_force = 0.0;  //!< N [N]
};

struct Zone {
  std::vector<Touch> touches;
  double factor = 1.0;       // 2 where the zone goes on as its mirror image across the centre plane
  double deflection = 0.0;   //!< w, down [m]
  double down = 0.0;         //!< vertical load on the edge [N]
  double share = 1.0;        // of the crushing pressure that the contact bears
  Vec3 area = Vec3::Zero();  //!< sum over the strips that press, without `factor` [m^2]
  double width = 0.0;        //!< along the edge, with the mirror image [m]
};

// Unit normal out of the hull, and the direction of friction on the ice: the hull's way along itself, without
// the part that would lift the ice more than the contact pushes it down.
struct Directions {
  Vec3 normal, friction;
};
Directions directions(const Vec3& area, double friction_coefficient);

// Load down on the ice for a normal force of 1 N.
double down_share(const Directions& d, double friction_coefficient);

// The same for a contact of that vector area [m^2], times the area's size: with p_c it is the load [m^2].
double down_area(const Vec3& area, double friction_coefficient);

class ZoneSolver {
 public:
  ZoneSolver(const Ice& ice, const HullFront& front, const Strips& strips, std::vector<IceStrip>& sheet);

  double stiffness() const { return stiffness_; }  //!< k of the floating edge [N/m]
  // Where the load of the hull at the advance X and the floating edge agree, at most `largest` [m] down or
  // up. `step` [m] is what the ship has come on since the deflections before.
  void settle(Zone& zone, double X, double largest, double step) const;

 private:
  struct Bounds {
    double largest, before, descent;  //!< of the deflection; of the hull on the edge in this step [m]
    double at_rest;                   //!< load at no deflection [N]
  };
  double deflection(Zone& zone, double X, const Bounds& bounds, double way) const;
  double load(Zone& zone, double X, double w) const;
  struct Level {
    int row;
    double part;  // of the way to the next row
  };
  Level level(double w) const;
  void touch(Touch& t, double X, const Level& level) const;
  void width(Zone& zone) const;

  const Ice& ice_;
  const HullFront& front_;
  const Strips& strips_;
  std::vector<IceStrip>& sheet_;
  double stiffness_;
};

}  // namespace icebow::cycle
