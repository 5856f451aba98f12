// The run of the checkpoint tests.
#pragma once

#include "solver/run/simulation.h"
#include "tests/support/test_folder.h"
#include "tests/support/tiny_hull.h"

namespace icebow {

// Two thousand particles; two ranks along x fit.
inline Scenario breaking_ice() {
  return tiny_run(1.28, 0.2);
}

}  // namespace icebow
