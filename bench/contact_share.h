// The share of contact in a whole step of a ship-ice run.
#pragma once

#include <cstddef>

namespace icebow {

struct ContactShare {
  std::size_t quads = 0;
  int contacts = 0;                    // particles touching the hull, mean of the timed steps
  double step_ms = 0, contact_ms = 0;  // wall time of one rank
  double share() const { return contact_ms / step_ms; }
};

// The paper's slab (500 x 250 x 3 particles, afloat) with a ship-like hull of about `quads` quads sailing in
// it.
ContactShare contact_share(int quads);

}  // namespace icebow
