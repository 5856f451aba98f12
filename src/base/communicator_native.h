// The MPI side of Communicator: for communicator_native.cpp and solver/ice/halo.cpp only.
#pragma once

#include <mpi.h>

#include "base/communicator.h"

namespace icebow {

struct Communicator::Native {
  MPI_Comm comm = MPI_COMM_NULL;
  bool owned = false;  // free it at the end
  ~Native();
};

}  // namespace icebow
