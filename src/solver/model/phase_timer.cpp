#include "solver/model/phase_timer.h"

namespace icebow {

const char* to_string(Phase phase) {
  static constexpr const char* names[phases] = {"drift",      "contact", "halo u",       "dilatation",
                                                "halo theta", "force",   "surroundings", "sampling",
                                                "energy",     "output",  "checkpoint",   "other"};
  return names[static_cast<int>(phase)];
}

}  // namespace icebow
