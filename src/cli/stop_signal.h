// SIGINT, SIGTERM and SIGHUP as a flag, so that a run ends in good order.
#pragma once

namespace icebow {

// While it lives, the first of these signals sets the flag; a second one of the same kind ends the program at
// once. A signal that the caller ignores (nohup) stays ignored. Progress that nobody reads any more (a closed
// pipe) ends nothing.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  static bool raised();
};

}  // namespace icebow
