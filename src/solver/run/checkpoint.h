// A run's state on disk, from which it goes on bit for bit, on any number of ranks.
//
// One HDF5 file with checksums throughout (see Checksums), so that what a disk has damaged is not gone on
// from: the sheet (see sheet_file.h), `history` and `history_counts` (a row a sample), `cracked_columns` and
// `dropped_ice` (process_watch.h), `run` (JSON: step, counts, files written so far) and `case` (see
// case_text.h), by which a checkpoint of another run is recognised. It is written under a second name, that
// of its process, and then renamed: a run that is killed while it writes leaves the checkpoint before.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "base/communicator.h"
#include "base/errors.h"
#include "solver/model/run_options.h"
#include "solver/output/snapshots.h"
#include "solver/step/stepper.h"
#include "solver/watch/process_watch.h"
#include "solver/watch/recorder.h"

namespace icebow {

// What a run consists of between two steps.
struct RunState {
  Stepper& stepper;
  Recorder& recorder;
  Snapshots& snapshots;
  ProcessWatch& process;
  LinearCount linear{};       // sum over the samples so far, this rank's
  double wall_seconds = 0.0;  // so far, of all its parts
};

// Collective; throws RuntimeError naming the file, which is then as it was before.
void save_checkpoint(const Communicator& comm, const std::string& path, const std::string& case_text,
                     const RunState& run);

// A checkpoint that is not as it was written.
class DamagedCheckpoint : public RuntimeError {
 public:
  using RuntimeError::RuntimeError;
};

// Collective. Empty where the file is a checkpoint of this case not beyond `last_step`, else in words why it
// is not; throws nothing. `damaged` tells one that is no whole checkpoint from one of another run.
std::string why_not_resumable(const Communicator& comm, const std::string& path, const std::string& case_text,
                              int precision, std::int64_t last_step, bool* damaged = nullptr);

// Collective, into a run that has not begun, which is of no use any more where this throws DamagedCheckpoint.
void load_checkpoint(const Communicator& comm, const std::string& path, RunState& run);

// With what a write that was killed has left beside it; one that stays is refused or continued at its end.
void remove_checkpoint(const std::string& path);

// When to do either, as the options of a run say.
class Checkpoints {
 public:
  Checkpoints(const Communicator& comm, const QuadMesh& hull, const Scenario& scenario,
              const RunOptions& options);

  // Collective: goes on from the checkpoint there is, if there is one and that is wanted; `last_step` is that
  // of the run as it is asked for now. Throws RuntimeError
  // where it is refused. A damaged one is set aside where a run may start anew (Resume::if_usable); where
  // parts of it have been read by then DamagedCheckpoint is thrown, and the run has to be made anew.
  void resume(RunState& run, std::int64_t last_step);
  // Collective, after a sample: writes where one is due by the root's clock, or where the run stops now.
  void write_due(const RunState& run, bool stopping);
  void remove();  // the run has come to its end

 private:
  using Clock = std::chrono::steady_clock;
  bool there() const;
  void set_aside(const std::string& reason) const;

  const Communicator& comm_;
  const RunOptions& options_;
  std::string case_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace icebow
