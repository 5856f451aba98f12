#include "cli/stop_signal.h"

#include <csignal>

namespace icebow {
namespace {

volatile std::sig_atomic_t stop_raised = 0;
struct sigaction before_int, before_term;

void raise_stop(int) {
  stop_raised = 1;
}

}  // namespace

StopSignal::StopSignal() {
  struct sigaction action = {};
  action.sa_handler = raise_stop;
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_int);
  sigaction(SIGTERM, &action, &before_term);
}

StopSignal::~StopSignal() {
  sigaction(SIGINT, &before_int, nullptr);
  sigaction(SIGTERM, &before_term, nullptr);
}

bool StopSignal::raised() {
  return stop_raised != 0;
}

}  // namespace icebow
