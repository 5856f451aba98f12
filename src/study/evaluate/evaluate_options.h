// How a design is evaluated: its files, its checkpoints, and who is told.
#pragma once

#include <cstdlib>
#include <functional>
#include <string>

#include "base/errors.h"
#include "base/printable.h"
#include "solver/run/simulation.h"

namespace icebow {

// Wall time between two checkpoints [s]: 300, or what ICEBOW_CHECKPOINT_SECONDS of the environment says, as
// jobs that are short or disks that are slow may want it. Throws InputError where that is no number from 0
// on.
inline double usual_checkpoint_interval() {
  const char* given = std::getenv("ICEBOW_CHECKPOINT_SECONDS");
  if (!given) return 300.0;
  char* end = nullptr;
  const double seconds = std::strtod(given, &end);
  if (end == given || *end != '\0' || !(seconds >= 0.0 && seconds <= 1e9))
    throw InputError("ICEBOW_CHECKPOINT_SECONDS=" + shortened(given, 40) +
                     " in the environment: must be a number, allowed 0 to 1e9 s; 0 = only when interrupted");
  return seconds;
}

struct EvaluateOptions {
  std::string directory;  // of this design's files; made where missing; empty = no files
  std::function<void(const Progress&)> on_progress;
  std::function<bool()> stop, checkpoint_now;  // see RunOptions
  // The simulation's checkpoint in that directory: see RunOptions.
  double checkpoint_every_s = usual_checkpoint_interval();
  Resume resume = Resume::if_usable;
  // At the end too: the caller removes it once the result is safe. Of a voyage that may be sailed on it is
  // the state of its end.
  bool keep_checkpoint = false;
  std::function<void(std::int64_t step)> on_resume;
  std::function<void(const std::string& words)> on_note;  // on the root: a checkpoint was set aside ...
};

constexpr const char* checkpoint_name = "checkpoint.h5";

}  // namespace icebow
