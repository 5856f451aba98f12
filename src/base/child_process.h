// A program in a process group of its own: started, listened to, ended.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace icebow {

struct ChildCommand {
  std::vector<std::string> arguments;    // the program first, looked up in PATH
  std::vector<std::string> environment;  // "NAME=value"
  std::string log;                       // takes its stderr
  std::string input;                     // what it reads on its stdin; empty: nothing
  std::string directory;                 // where it runs; empty: where this process is
  int when_we_die = SIGTERM;  // what the kernel sends it when this process dies, however that happens
};

// Whether there is such a program: a path, or a name that stands in PATH.
bool can_be_started(const std::string& program);

class ChildProcess {
 public:
  // Throws RuntimeError where the program cannot be started.
  explicit ChildProcess(const ChildCommand& command);
  ~ChildProcess();  // kills what still runs, and waits for it
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  int output() const { return output_; }  // file descriptor of its stdout, for poll(); -1 once it is closed
  // Whole lines that have come since, and at the end what is left; of a flood some, the rest when it is
  // called again. A line of more than 16 MB comes in parts.
  std::vector<std::string> read_lines();
  bool running();          // false once it has ended; the exit status is then known
  double seconds() const;  // since the start

  // SIGTERM to the group; SIGKILL where it still runs after the grace period. The latter needs running() to
  // be called.
  void terminate(std::chrono::milliseconds grace);

  // "exit code 3", "killed by signal 11 (Segmentation fault)"; empty where the exit code is 0 or it still
  // runs.
  std::string complaint() const;
  int killed_by() const;  // the signal, of a rank under mpirun too; 0 where there was none, or it still runs
  int exit_code() const;  // 0 where it still runs

 private:
  using Clock = std::chrono::steady_clock;
  pid_t pid_ = -1;
  int output_ = -1;
  int status_ = 0;
  bool running_ = false, terminating_ = false;
  Clock::time_point start_, kill_at_;
  std::string partial_line_;
};

// Waits until one of them says something or ends its output, at most `limit`.
void wait_for_output(const std::vector<const ChildProcess*>& children, std::chrono::milliseconds limit);

// This process's environment with what Open MPI wants on a few cores or as root. Where an MPI launcher
// started this process, what it left there is taken out: mpirun would take itself for a rank.
std::vector<std::string> child_environment();

}  // namespace icebow
