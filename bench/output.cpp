// Time of each kind of output beside that of a step, on a sheet of 500 x 250 x 3 particles with a hull in it.
//
//   bench/output [DIR]      also under mpirun -n N; writes to DIR (default: the current directory)
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

#include "solver/ice/local_cloud.h"
#include "solver/ice/sheet_state.h"
#include "solver/output/vtkhdf.h"
#include "solver/output/vtp.h"
#include "solver/run/checkpoint.h"
#include "solver/run/simulation.h"
#include "tests/support/tiny_hull.h"

using namespace icebow;

namespace {

Scenario reference_slab() {
  Scenario s;
  s.ice = {0.039, 826.6, 52e6, 0.33, 0.0052, 0.0};
  s.sheet = {6.5, 3.25, FixedEdges::sides};
  s.numerics.dx = 0.013;
  s.V = 0.5;
  s.advance = 3.0;
  return s;
}

template <class Work>
double timed(const Communicator& comm, const char* what, int repeats, const Work& work) {
  comm.barrier();
  const auto begin = std::chrono::steady_clock::now();
  for (int n = 0; n < repeats; ++n) work();
  comm.barrier();
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() / repeats;
  if (comm.is_root()) std::printf("%-42s %10.2f ms\n", what, ms);
  return ms;
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(argc, argv);
  const Communicator comm = mpi.world();
  const std::string folder = argc > 1 ? argv[1] : ".";
  const Scenario s = reference_slab();
  const QuadMesh hull = sloping_box(0.45, 0.9, 0.3, 0.3, 5.0);
  const Lattice lattice = make_lattice(s);
  Stepper stepper(comm, hull, s, lattice, run_size(hull, s).dt, first_touch_x(hull, lattice));
  Recorder recorder(comm, stepper, s);
  RunOptions options;
  options.directory = folder;
  options.pictures = 1;
  Snapshots snapshots(comm, hull, s, options);
  ProcessWatch process(comm, hull, s, stepper, recorder.steps_per_sample());
  RunState run{stepper, recorder, snapshots, process};

  timed(comm, "step", 200, [&] { stepper.step(); });
  IceCloud own;
  timed(comm, "ParaView step: fields and pieces", 3, [&] { own = local_cloud(comm, stepper.sheet()); });
  const std::string part = folder + "/bench_p" + std::to_string(comm.rank()) + ".vtp";
  timed(comm, "ParaView step: vtp, a file a rank", 3, [&] { write_ice_vtp(part, own); });
  timed(comm, "ParaView step: vtkhdf", 3, [&] { write_ice_vtkhdf(comm, folder + "/bench.hdf", own, false); });
  timed(comm, "sheet gathered, for a picture or the metrics", 1,
        [&] { gather_state(comm, stepper.sheet()); });
  timed(comm, "picture, sheet gathered", 1, [&] { snapshots.write_due(stepper, s.advance, {}); });
  const std::string checkpoint = folder + "/bench.h5";
  timed(comm, "checkpoint, to the disk", 3, [&] { save_checkpoint(comm, checkpoint, "bench", run); });
  if (comm.is_root()) std::printf("checkpoint %.1f MB\n", 1e-6 * std::filesystem::file_size(checkpoint));
  timed(comm, "checkpoint read", 1, [&] { load_checkpoint(comm, checkpoint, run); });

  std::filesystem::remove(part);
  comm.barrier();
  if (!comm.is_root()) return 0;
  for (const char* file : {"/bench.hdf", "/bench.h5", "/ice_000.png"}) std::filesystem::remove(folder + file);
}
