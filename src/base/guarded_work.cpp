#include "base/guarded_work.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/errors.h"

namespace icebow {
namespace {

// Signals as a fresh program has them: handlers of this one would tell of a crash of its own.
void forget_handlers() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGTERM, SIGINT, SIGHUP, SIGALRM})
    std::signal(signal, SIG_DFL);
}

[[noreturn]] void be_copy(const std::function<std::string()>& work, int seconds, int out) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  forget_handlers();
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  alarm(static_cast<unsigned>(seconds));
  const std::string bytes = work();
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(out, bytes.data() + done, bytes.size() - done);
    if (n <= 0) _exit(1);
    done += static_cast<std::size_t>(n);
  }
  _exit(0);
}

std::string all_of(int in) {
  std::string bytes;
  char buffer[1 << 16];
  for (ssize_t n = 0; (n = ::read(in, buffer, sizeof buffer)) != 0;) {
    if (n > 0) bytes.append(buffer, static_cast<std::size_t>(n));
    if (n < 0 && errno != EINTR) break;
  }
  return bytes;
}

std::string trouble_of(int status, int seconds) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "took longer than " + std::to_string(seconds) + " s";
  if (WIFSIGNALED(status))
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) +
           ")";
  return WEXITSTATUS(status) == 0 ? "" : "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

GuardedResult guarded_work(const std::function<std::string()>& work, int seconds) {
  int ends[2];
  if (pipe(ends) != 0)
    throw RuntimeError(std::string("no pipe to a copy of the program: ") + std::strerror(errno));
  const pid_t copy = fork();
  if (copy == 0) {
    ::close(ends[0]);
    be_copy(work, seconds, ends[1]);
  }
  const int error = errno;
  ::close(ends[1]);
  GuardedResult result;
  if (copy > 0) result.bytes = all_of(ends[0]);
  ::close(ends[0]);
  if (copy < 0) throw RuntimeError(std::string("no copy of the program: ") + std::strerror(error));
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) continue;
  result.trouble = trouble_of(status, seconds);
  return result;
}

}  // namespace icebow
