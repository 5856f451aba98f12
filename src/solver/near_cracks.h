// Ice that other ice may meet: near broken bonds.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "base/communicator.h"
#include "solver/sheet.h"

namespace icebow {

// visit(jl, k, il) for each of this rank's particles in a block that is within 16 particles along and across
// the course of one with a broken or nearly broken bond, on any rank. Collective.
void near_cracks(const Communicator& comm, const IceSheet& sheet,
                 const std::function<void(int jl, int k, int il)>& visit);

// Whether a bond joins two particles, of which a rank asks for its own and any others.
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
