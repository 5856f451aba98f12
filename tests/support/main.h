#pragma once

#include "base/communicator.h"

namespace icebow {

// All ranks of the test run; one rank, without MPI, where mpirun did not start it.
const Communicator& test_world();

}  // namespace icebow
