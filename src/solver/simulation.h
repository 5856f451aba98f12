// One ship-ice run: a hull sails into a floating sheet of level ice at constant speed.
#pragma once

#include <functional>
#include <string>

#include "base/communicator.h"
#include "base/quad_mesh.h"
#include "solver/breaking_process.h"
#include "solver/history.h"
#include "solver/metrics.h"
#include "solver/profile.h"
#include "solver/scenario.h"
#include "solver/snapshot_format.h"

namespace icebow {

struct Progress {
  std::int64_t step = 0, steps = 0;
  double advance = 0.0;        //!< [m]
  double load = 0.0;           //!< latest resistance sample [N]
  double seconds = 0.0;        //!< wall time so far
  double ns_per_bond = 0.0;    //!< per directed bond per step
  double hull_work = 0.0;      //!< of the hull on the ice [J]
  double balance_error = 0.0;  //!< of the energy balance when it was last drawn up [J]
};

// What to do with a checkpoint that is already there.
enum class Resume {
  never,      // start anew; it stays until the next one takes its place
  always,     // go on from it; one that is not of this run, or not whole, is an error
  if_usable,  // go on from it, or start anew where that is impossible
};

struct RunOptions {
  // Where ice.pvd (or ice.vtkhdf.series), hull.pvd, their steps and ice_*.png go; empty = no files.
  std::string directory;
  int snapshots = 0;  // ParaView snapshots, equally spaced in advance, the last one at the end
  SnapshotFormat snapshot_format = SnapshotFormat::vtp;
  // Above 0: the ice starts with small random velocities that are this seed's (solver/stir.h); 0 = at rest.
  std::uint64_t seed = 0;
  int pictures = 0;                                  // top-view PNG pictures, likewise: ice_000.png ...
  std::function<void(const Progress&)> on_progress;  // called on the root rank about four times a second
  std::function<bool()> stop;  // asked on the root about as often; true = end now with status interrupted
  // HDF5 file from which an interrupted run goes on; empty = none. It is removed when the run has ended.
  std::string checkpoint_file;
  double checkpoint_every_s = 300.0;  // wall time between two; 0 = only when the run is interrupted
  Resume resume = Resume::always;
  std::function<void(std::int64_t step)> on_resume;  // called on the root where the run goes on from one
};

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
  Profile profile;                      // where the wall time went
  double linear_share = 0.0;            // of the blocks, mean of the samples: ice of the linear law
  double output_seconds = 0.0;          // of the wall time, since the run was started: files and pictures
  std::vector<std::string> pictures;    // file names in the directory, in order
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
