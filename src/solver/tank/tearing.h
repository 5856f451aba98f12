// Ice that tears at rest: its load is raised from nothing until the bonds that are worst off break, again and
// again. Between two breaks the ice is linear, so one equilibrium tells the load at which the next will be.
#pragma once

#include <algorithm>

#include "solver/ice/cut.h"
#include "solver/tank/still_ice.h"

namespace icebow {

// A bond's stretch, for small displacements.
inline double stretch(const StillIce& ice, int i, int j, int k, const Offset& o) {
  const double dx = ice.ice.lattice.dx;
  const Vec3 xi(o.di * dx, o.dj * dx, o.dk * dx);
  return xi.dot(ice.u(i + o.di, j + o.dj, k + o.dk) - ice.u(i, j, k)) / (o.length * o.length);
}

// A bond's stretch, or the normal stress across it, over what breaks it; in proportion to the load.
inline double demand(const StillIce& ice, int i, int j, int k, const Offset& o) {
  const Material& m = ice.ice.material;
  const double s = stretch(ice, i, j, k, o);
  if (!(m.tensile_strength > 0.0)) return s / m.s0;
  const double theta = 0.5 * (ice.theta(i, j, k) + ice.theta(i + o.di, j + o.dj, k + o.dk));
  return m.normal_stress(s, theta) / m.tensile_strength;
}

// may_break(i, j, k, offset) names the bonds that may break. Not above 0 where none is pulled.
template <class MayBreak>
double largest_demand(StillIce& ice, MayBreak may_break) {
  double largest = 0.0;
  cut(ice.ice.sheet, [&](int i, int j, int k, const Offset& o) {
    if (may_break(i, j, k, o)) largest = std::max(largest, demand(ice, i, j, k, o));
    return false;
  });
  return largest;
}

// Returns how many bonds broke.
template <class MayBreak>
std::int64_t break_above(StillIce& ice, double limit, MayBreak may_break) {
  return cut(ice.ice.sheet, [&](int i, int j, int k, const Offset& o) {
    return may_break(i, j, k, o) && demand(ice, i, j, k, o) > limit;
  });
}

struct Tear {
  double load;         // over the forces that push the ice
  std::int64_t bonds;  // broken at it
};

template <class MayBreak>
Tear tear(StillIce& ice, MayBreak may_break) {
  ice.settle(1e-4);
  const double largest = largest_demand(ice, may_break);
  // Bonds that mirror each other break together.
  return {1.0 / largest, break_above(ice, 0.999 * largest, may_break)};
}

struct Failure {
  double first = 0.0, highest = 0.0;  // load before the first bond breaks; at the peak
  int breaks = 0;                     // equilibria that the piece went through
};

// Breaks bonds until the load the piece carries is well below its highest. load() is the support's at the
// displacements given, between which and the break everything is in proportion.
template <class MayBreak, class Load>
Failure tear_until_it_fails(StillIce& ice, const MayBreak& may_break, const Load& load) {
  // Unbalanced forces at an equilibrium. At 1e-4 the crack has not felt its last bond when the next one goes:
  // the strength comes out a tenth higher.
  constexpr double balance = 1e-6;
  constexpr double together = 1e-3;  // bonds this near to the most stretched break with it: its mirror images
  constexpr double fallen = 0.8;     // of the highest load: the test is over
  Failure failure;
  for (double now = 0.0; now >= fallen * failure.highest; ++failure.breaks) {
    ice.settle(balance);
    const double demand = largest_demand(ice, may_break);
    if (!(demand > 0.0)) break;
    const double unit = load();
    now = unit / demand;
    if (failure.breaks == 0) failure.first = unit;
    failure.highest = std::max(failure.highest, now);
    break_above(ice, (1.0 - together) * demand, may_break);
  }
  return failure;
}

}  // namespace icebow
