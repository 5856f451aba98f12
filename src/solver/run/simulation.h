// One ship-ice run: a hull sails into a floating sheet of level ice at constant speed.
#pragma once

#include <string>
#include <vector>

#include "base/communicator.h"
#include "geometry/quad_mesh.h"
#include "solver/model/breaking_process.h"
#include "solver/model/history.h"
#include "solver/model/metrics.h"
#include "solver/model/run_options.h"
#include "solver/model/scenario.h"
#include "solver/watch/profile.h"

namespace icebow {

enum class RunStatus { ok, failed, interrupted };
enum class RunEnd { advance_reached, interval_narrow_enough };  // why a run that is ok ended

struct RunResult {
  RunStatus status = RunStatus::failed;
  std::string reason;  // why it failed, with time, step, place and likely cause
  RunEnd ended = RunEnd::advance_reached;
  History history;
  Metrics metrics;
  BreakingProcess process;
  double dt = 0.0;                  //!< [s]
  double dt_limit = 0.0;            //!< stability limit used [s]
  double s0 = 0.0;                  // critical stretch used
  int nx = 0, ny = 0, nz = 0;       // particles along x, y, z; of a half model ny of the port half
  std::int64_t directed_bonds = 0;  // simulated; without those across a half model's plane
  std::int64_t steps = 0;
  double wall_seconds = 0.0, ns_per_bond = 0.0;
  Profile profile;                    // where the wall time went
  std::int64_t profiled_steps = 0;    // that the profile is of: those since the run was started or continued
  double linear_share = 0.0;          // of the blocks, mean of the samples: ice of the linear law
  double output_seconds = 0.0;        // of the wall time, since the run was started: files and pictures
  std::vector<std::string> pictures;  // file names in the directory, in order
  std::vector<double> picture_advance;  //!< [m]
};

// Collective; every rank returns the same result. The hull is in its own frame (see QuadMesh) and at the
// scale of the scenario. Throws InputError for a scenario that cannot be run (a sheet narrower than the hull,
// dt above the limit).
RunResult simulate(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
                   const RunOptions& options);

// The number of steps and bonds a run will take, without running it.
struct RunSize {
  int nx = 0, ny = 0, nz = 0;  // as RunResult's
  std::int64_t steps = 0;
  double dt = 0.0, dt_limit = 0.0;
};
RunSize run_size(const QuadMesh& hull, const Scenario& scenario);

}  // namespace icebow
