// Work of a library that may crash or never end, in a copy of this process.
#pragma once

#include <functional>
#include <string>

namespace icebow {

struct GuardedResult {
  std::string bytes;  // what the work has returned
  std::string
      trouble;  // "was killed by signal 11 (Segmentation fault)", "took longer than 300 s"; else empty
};

// Nothing else that the work does is seen here; it must not throw, and must not talk to other ranks. Throws
// RuntimeError where there can be no copy.
GuardedResult guarded_work(const std::function<std::string()>& work, int seconds);

}  // namespace icebow
