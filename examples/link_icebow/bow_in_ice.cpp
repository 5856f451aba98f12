// A bow from four angles, its hydrostatics, and a short run of its 1:25 model through level ice.
//   bow_in_ice            mpirun -n 4 bow_in_ice
#include <cstdio>

#include "base/communicator.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/hydro/hydrostatics.h"
#include "solver/run/simulation.h"

int main(int argc, char** argv) {
  using namespace icebow;
  const MpiSession mpi(argc, argv);
  const Communicator world = mpi.world();

  BowParameters bow = preset_bow(BowFamily::straight_parallel_buttocks);
  bow.panel = 1.0;  // [m], coarse: the run takes seconds
  const Hull hull = make_hull(bow);
  if (hull.status != HullStatus::ok) {
    if (world.is_root()) std::fprintf(stderr, "%s\n", hull.reason.c_str());
    return 1;
  }

  Scenario run;  // SI, at the scale of the model
  run.ice = {0.04, 900.0, 52e6, 0.33, 0.0, 5e3};
  run.sheet.length = 1.2;
  run.sheet.width = 1.6;
  run.numerics.dx = 0.02;
  run.V = 0.4;
  run.advance = 0.15;
  run.steady_from = 0.05;
  const RunResult result = simulate(world, scaled(hull.mesh, 1.0 / 25.0), run, RunOptions());
  if (world.is_root()) {
    std::printf("displaced volume %.0f m3\n", displaced_volume(hull.mesh, 0.0));
    std::printf("mean load of the model %.1f N over %zu samples, %s\n", result.metrics.resistance.mean,
                result.history.rows.size(), result.status == RunStatus::ok ? "ok" : result.reason.c_str());
  }
  return result.status == RunStatus::ok ? 0 : 1;
}
