#include "base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include "base/communicator.h"
#include "base/errors.h"

namespace icebow {
namespace {

std::vector<char*> pointers(const std::vector<std::string>& strings) {
  std::vector<char*> list;
  for (const std::string& s : strings) list.push_back(const_cast<char*>(s.c_str()));
  list.push_back(nullptr);
  return list;
}

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw RuntimeError(std::string("no pipe to a child: ") + std::strerror(errno));
    read = ends[0];
    write = ends[1];
  }
};

// What a child's standard files become, and where it tells that it could not start.
struct Ends {
  int input, output, log, trouble;
};

// Between fork and exec: system calls only. Never returns.
[[noreturn]] void become(char* const* arguments, char* const* environment, const char* directory,
                         const Ends& ends, pid_t parent, int death_signal) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, death_signal);
  if (getppid() != parent) _exit(127);  // it died before the line above
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(ends.input, 0);
  dup2(ends.output, 1);
  dup2(ends.log, 2);
  if (*directory == '\0' || chdir(directory) == 0) execvpe(arguments[0], arguments, environment);
  const int error = errno;
  if (write(ends.trouble, &error, sizeof error) < 0) _exit(126);
  _exit(127);
}

// A file in memory: a pipe would want somebody to fill it while the child reads.
int file_of(const std::string& input) {
  if (input.empty()) return ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int file = memfd_create("icebow_input", MFD_CLOEXEC);
  std::size_t done = 0;
  while (file >= 0 && done < input.size()) {
    const ssize_t n = ::write(file, input.data() + done, input.size() - done);
    if (n <= 0) throw RuntimeError(std::string("no input for a child: ") + std::strerror(errno));
    done += static_cast<std::size_t>(n);
  }
  lseek(file, 0, SEEK_SET);
  return file;
}

bool starts_with(const std::string& text, const char* prefix) {
  return text.rfind(prefix, 0) == 0;
}

}  // namespace

bool can_be_started(const std::string& program) {
  if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/bin:/usr/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access(((folder.empty() ? "." : folder) + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

// mpirun ends its ranks on SIGTERM and cannot on SIGKILL; any other program obeys SIGTERM as well.
ChildProcess::ChildProcess(const ChildCommand& command) : start_(Clock::now()) {
  const std::vector<char*> arguments = pointers(command.arguments),
                           environment = pointers(command.environment);
  const int log = ::open(command.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (log < 0) throw RuntimeError(command.log + ": cannot be written: " + std::strerror(errno));
  const int input = file_of(command.input);
  const Pipe output, trouble;
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    become(arguments.data(), environment.data(), command.directory.c_str(),
           {input, output.write, log, trouble.write}, parent, command.when_we_die);
  }
  const int fork_error = errno;
  for (const int file : {input, log, output.write, trouble.write}) ::close(file);
  int error = pid_ < 0 ? fork_error : 0;
  if (pid_ > 0) {
    setpgid(pid_, pid_);                                             // whichever of the two comes first
    if (::read(trouble.read, &error, sizeof error) <= 0) error = 0;  // closed by exec: started
  }
  ::close(trouble.read);
  output_ = output.read;
  fcntl(output_, F_SETFL, O_NONBLOCK);
  if (error == 0) {
    running_ = true;
    return;
  }
  ::close(output_);
  if (pid_ > 0) waitpid(pid_, nullptr, 0);
  throw RuntimeError(command.arguments[0] + ": cannot be started: " + std::strerror(error));
}

ChildProcess::~ChildProcess() {
  if (running_) {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (output_ >= 0) ::close(output_);
}

std::vector<std::string> ChildProcess::read_lines() {
  constexpr std::size_t most_at_once = std::size_t{1} << 20, longest_line = std::size_t{1} << 24;
  std::array<char, 65536> buffer;
  ssize_t n = -1;
  for (std::size_t taken = 0; output_ >= 0 && taken < most_at_once; taken += static_cast<std::size_t>(n)) {
    n = ::read(output_, buffer.data(), buffer.size());
    if (n <= 0) break;
    partial_line_.append(buffer.data(), static_cast<std::size_t>(n));
  }
  if (n == 0) ::close(std::exchange(output_, -1));  // no more to come: poll() would report that over and over
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = partial_line_.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(partial_line_.substr(begin, end - begin));
  partial_line_.erase(0, begin);
  if ((n == 0 && !partial_line_.empty()) || partial_line_.size() > longest_line)
    lines.push_back(std::exchange(partial_line_, ""));
  return lines;
}

bool ChildProcess::running() {
  if (!running_) return false;
  if (terminating_ && Clock::now() > kill_at_) kill(-pid_, SIGKILL);
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) != pid_) return true;
  status_ = status;
  running_ = false;
  return false;
}

double ChildProcess::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ChildProcess::terminate(std::chrono::milliseconds grace) {
  if (!running_ || terminating_) return;
  terminating_ = true;
  kill_at_ = Clock::now() + grace;
  kill(-pid_, SIGTERM);
}

int ChildProcess::exit_code() const {
  return !running_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : 0;
}

int ChildProcess::killed_by() const {
  if (running_) return 0;
  if (WIFSIGNALED(status_)) return WTERMSIG(status_);
  const int code = exit_code();
  return code > 128 && code <= 128 + SIGSYS ? code - 128
                                            : 0;  // mpirun passes a rank's signal on like a shell
}

std::string ChildProcess::complaint() const {
  if (running_) return "";
  const int signal = killed_by(), code = exit_code();
  if (signal != 0) return "killed by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  return code != 0 ? "exit code " + std::to_string(code) : "";
}

void wait_for_output(const std::vector<const ChildProcess*>& children, std::chrono::milliseconds limit) {
  std::vector<pollfd> files;
  for (const ChildProcess* child : children) files.push_back({child->output(), POLLIN, 0});
  poll(files.data(), files.size(), static_cast<int>(limit.count()));
}

std::vector<std::string> child_environment() {
  const bool launched = MpiSession::started_by_mpirun();  // else OMPI_MCA_... is what the user has set
  std::vector<std::string> list;
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    bool drop = starts_with(text, "OPENTURNS_NUM_THREADS=");
    for (const char* prefix : {"OMPI_", "PMIX_", "PMI_", "PRTE_"}) {
      drop = drop || (launched && starts_with(text, prefix));
    }
    if (!drop) list.push_back(text);
  }
  for (const char* text : {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                           "OMPI_MCA_mpi_yield_when_idle=1", "OPENTURNS_NUM_THREADS=1"}) {
    list.emplace_back(text);
  }
  return list;
}

}  // namespace icebow
