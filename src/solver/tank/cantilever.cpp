#include "solver/tank/cantilever.h"

#include <cmath>

namespace icebow {

BeamTest beam_test(const Cantilever& c, double stiffness, const Failure& failure) {
  // Deflection by bending, 4 F L^3 / (E b h^3), and by shear, F L / (5/6 G b h).
  const double bending = 4.0 * std::pow(c.length / c.thickness, 3.0) / c.width,
               shear = 2.0 * (1.0 + c.nu) * 6.0 / 5.0 * c.length / (c.width * c.thickness);
  return {stiffness * (bending + shear),
          6.0 * failure.highest * c.length / (c.width * c.thickness * c.thickness), failure.breaks};
}

}  // namespace icebow
