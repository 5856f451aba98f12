// SIGINT and SIGTERM as a flag, so that a run ends in good order.
#pragma once

namespace icebow {

// While it lives, the first SIGINT or SIGTERM sets the flag; a second one of the same kind ends the program
// at once.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  static bool raised();
};

}  // namespace icebow
