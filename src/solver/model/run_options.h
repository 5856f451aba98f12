// What a run is asked besides its scenario: files, checkpoints, and who is told of its progress.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "solver/model/snapshot_format.h"

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
  if_usable,  // go on from it, or start anew where that is impossible; one that is damaged is set aside
};

struct RunOptions {
  // Where the files for ParaView (docs/paraview.md) and ice_*.png go; empty = no files.
  std::string directory;
  std::string name;     // of the design, in the titles of pictures
  double lambda = 1.0;  // full scale / this run's scale, for the titles and scale bars of pictures
  int snapshots = 0;    // ParaView steps after that of time 0, equally spaced in advance
  SnapshotFormat snapshot_format = SnapshotFormat::vtp;
  // Above 0: the ice starts with small random velocities that are this seed's (solver/ice/stir.h); 0 = at
  // rest.
  std::uint64_t seed = 0;
  int pictures = 0;                                  // top-view PNG pictures, likewise: ice_000.png ...
  std::function<void(const Progress&)> on_progress;  // called on the root rank about four times a second
  // Asked on the root some ten times a second, or after each step that takes longer: whether to end now with
  // status interrupted, and whether to write a checkpoint now and go on.
  std::function<bool()> stop, checkpoint_now;
  // HDF5 file from which an interrupted run goes on; empty = none. It is removed when the run has ended, or
  // left to the caller, whose results may still have to be written.
  std::string checkpoint_file;
  bool keep_checkpoint = false;
  // Leave one of its end, from which the same run with a longer advance goes on bit for bit; in a moving
  // window, whose ice does not depend on the voyage's length. Implies keep_checkpoint.
  bool to_be_sailed_on = false;
  double checkpoint_every_s = 300.0;  // wall time between two; 0 = only when the run is interrupted
  Resume resume = Resume::always;
  std::function<void(std::int64_t step)> on_resume;       // called on the root where the run goes on from one
  std::function<void(const std::string& words)> on_note;  // on the root: a checkpoint was set aside, and why
};

}  // namespace icebow
