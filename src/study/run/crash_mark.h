// A word left behind by a program that ends by a fault of its own.
//
// Where designs share the process of a study, a crash ends the study too. What was under way is then either
// the culprit or the victim of somebody who killed the job: only the former leaves a mark.
#pragma once

#include <string>

namespace icebow {

// While it lives, a signal that a fault raises (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) writes the file
// before it takes its course. One at a time.
class CrashMark {
 public:
  explicit CrashMark(const std::string& path);
  ~CrashMark();
  CrashMark(const CrashMark&) = delete;
  CrashMark& operator=(const CrashMark&) = delete;
};

constexpr const char* crash_mark_name = "crashed.txt";

// What the mark says, "signal 11 (process 4711, 1700000000)"; empty where there is none.
std::string crash_mark_in(const std::string& directory);

}  // namespace icebow
