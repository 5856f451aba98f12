// One main for all tests: MPI lives around Catch where mpirun started the test.
#define CATCH_CONFIG_RUNNER
#include "tests/support/main.h"

#include <catch2/catch.hpp>

namespace icebow {

static const Communicator* world = nullptr;
const Communicator& test_world() {
  return *world;
}

}  // namespace icebow

int main(int argc, char** argv) {
  icebow::MpiSession mpi(argc, argv);
  const icebow::Communicator comm = mpi.world();
  icebow::world = &comm;
  return Catch::Session().run(argc, argv);
}
