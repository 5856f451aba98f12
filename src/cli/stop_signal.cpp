#include "cli/stop_signal.h"

#include <csignal>

namespace icebow {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t stop_raised = 0;
struct sigaction before[3], pipe_before;

void raise_stop(int) {
  stop_raised = 1;
}

}  // namespace

StopSignal::StopSignal() {
  struct sigaction action = {};
  action.sa_handler = raise_stop;
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  for (int k = 0; k < 3; ++k) {
    sigaction(signals[k], &action, &before[k]);
    if (before[k].sa_handler == SIG_IGN) sigaction(signals[k], &before[k], nullptr);  // nohup
  }
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, &pipe_before);
}

StopSignal::~StopSignal() {
  for (int k = 0; k < 3; ++k) sigaction(signals[k], &before[k], nullptr);
  sigaction(SIGPIPE, &pipe_before, nullptr);
}

bool StopSignal::raised() {
  return stop_raised != 0;
}

}  // namespace icebow
