// Signals as flags, so that a run ends in good order.
#pragma once

namespace icebow {

// While it lives, the first SIGINT, SIGTERM, SIGHUP or SIGUSR1 sets the flag to stop; a second one of the
// same kind ends the program at once. A signal that the caller ignores (nohup) stays ignored. Progress that
// nobody reads any more (a closed pipe) ends nothing.
//
// mpirun and batch systems send SIGCONT a moment before SIGTERM, and SIGKILL soon after it. So SIGCONT asks
// for a checkpoint. mpirun hands SIGUSR1 on to its ranks without a hurry.
class StopSignal {
 public:
  // What a signal does before raised() is asked for the first time.
  enum class Unheeded { waits, ends };  // sets the flag, ends the program at once
  explicit StopSignal(Unheeded unheeded = Unheeded::waits);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  static bool raised();
  static bool checkpoint_asked();  // whether a SIGCONT has come since it was asked last
};

}  // namespace icebow
