#include "base/stop_signal.h"

#include <csignal>

namespace icebow {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};
constexpr int count = sizeof signals / sizeof *signals;

volatile std::sig_atomic_t stop_raised = 0, continued = 0, heeded = 1;
struct sigaction before[count], pipe_before, continue_before;

void raise_stop(int signal) {
  stop_raised = 1;
  if (!heeded) raise(signal);  // SA_RESETHAND: ends the program
}

void note_continue(int) {
  continued = 1;
}

}  // namespace

StopSignal::StopSignal(Unheeded unheeded) {
  heeded = unheeded == Unheeded::waits;
  struct sigaction action = {};
  action.sa_handler = raise_stop;
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  for (int k = 0; k < count; ++k) {
    sigaction(signals[k], &action, &before[k]);
    if (before[k].sa_handler == SIG_IGN) sigaction(signals[k], &before[k], nullptr);  // nohup
  }
  action.sa_flags = SA_RESTART;
  action.sa_handler = note_continue;
  sigaction(SIGCONT, &action, &continue_before);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, &pipe_before);
}

StopSignal::~StopSignal() {
  for (int k = 0; k < count; ++k) sigaction(signals[k], &before[k], nullptr);
  sigaction(SIGCONT, &continue_before, nullptr);
  sigaction(SIGPIPE, &pipe_before, nullptr);
}

bool StopSignal::raised() {
  heeded = 1;
  return stop_raised != 0;
}

bool StopSignal::checkpoint_asked() {
  const bool asked = continued != 0;
  continued = 0;
  return asked;
}

}  // namespace icebow
