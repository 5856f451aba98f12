// Whether a bond joins two particles, wherever they are now.
#pragma once

#include <array>
#include <vector>

#include "solver/ice/sheet.h"

namespace icebow {

class BondQuery {
 public:
  using Place = std::array<int, 3>;  // i, j, k in the lattice; j below 0: image in the plane of symmetry

  explicit BondQuery(const IceSheet& sheet);
  // `own` is this rank's.
  bool alive(const Place& own, const Place& other) const;

 private:
  const IceSheet& sheet_;
  std::vector<int> slot_;  // [layer][offset] of those to higher ends; -1 = not in the family
};

}  // namespace icebow
