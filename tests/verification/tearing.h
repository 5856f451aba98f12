// Ice that tears at rest: its load is raised from nothing until the most stretched bonds break, again and
// again.
#pragma once

#include <algorithm>

#include "cut.h"
#include "still_ice.h"

namespace icebow {

struct Tear {
  double load;         // over the forces that push the ice
  std::int64_t bonds;  // broken at it
};

// may_break(i, j, k, offset) names the bonds that the test leaves to break.
template <class MayBreak>
Tear tear(StillIce& ice, MayBreak may_break) {
  ice.settle(1e-4);
  const double dx = ice.ice.lattice.dx;
  const auto stretch = [&](int i, int j, int k, const Offset& o) {  // for small displacements
    const Vec3 xi(o.di * dx, o.dj * dx, o.dk * dx);
    return xi.dot(ice.u(i + o.di, j + o.dj, k + o.dk) - ice.u(i, j, k)) / (o.length * o.length);
  };
  double largest = 0.0;
  cut(ice.ice.sheet, [&](int i, int j, int k, const Offset& o) {
    if (may_break(i, j, k, o)) largest = std::max(largest, stretch(i, j, k, o));
    return false;
  });
  // Bonds that mirror each other break together.
  const std::int64_t bonds = cut(ice.ice.sheet, [&](int i, int j, int k, const Offset& o) {
    return may_break(i, j, k, o) && stretch(i, j, k, o) > 0.999 * largest;
  });
  return {ice.ice.material.s0 / largest, bonds};
}

}  // namespace icebow
