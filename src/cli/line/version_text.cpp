#include "cli/line/version_text.h"

#include <icebow_commit.h>  // written by cmake/commit.cmake at each build
#include "base/communicator.h"
#include "solver/kernel/kernel.h"
#include "study/evaluate/provenance.h"

namespace icebow {

std::string version_text() {
  const Kernels& kernel = kernels();
  return "icebow " + program_version() + "\n" +   //
         "commit    " + ICEBOW_COMMIT + "\n" +    //
         "compiler  " + ICEBOW_COMPILER + "\n" +  //
         "MPI       " + mpi_library() + "\n" +    //
         "vectors   " + kernel.name + ", " + std::to_string(8 * kernel.vector_bytes) + " bit\n" +
         "parts     " + ICEBOW_PARTS + "\n";
}

}  // namespace icebow
