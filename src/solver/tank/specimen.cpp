#include "solver/tank/specimen.h"

#include <cmath>
#include <string>

#include "base/errors.h"

namespace icebow {

int tested_layers(const Scenario& s) {
  const int layers = static_cast<int>(std::lround(s.ice.h / s.numerics.dx));
  if (layers < 2) {
    throw InputError("ice of " + std::to_string(layers) +
                     " layer cannot bend, so no beam of it has a flexural strength: ask for two layers or "
                     "more (/solver/layers)");
  }
  return layers;
}

Scenario specimen(const Scenario& s, int nx, int ny, int layers) {
  Scenario p;
  p.ice = s.ice;
  p.ice.h = layers * s.numerics.dx;
  p.water = s.water;
  p.numerics = s.numerics;
  p.numerics.linear_below = 0.0;  // the displacements are linear as they are
  p.sheet = {nx * s.numerics.dx, ny * s.numerics.dx, FixedEdges::none};
  p.V = 1.0;  // energies are not asked for
  return p;
}

}  // namespace icebow
