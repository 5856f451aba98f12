#include "study/run/crash_mark.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <filesystem>
#include <vector>

#include "base/text_file.h"

namespace icebow {
namespace {

constexpr int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int most_signals = 5;

char mark_path[4096];
struct sigaction before[most_signals];

// In a handler of signals: no allocation, no formatting of the library's.
void append(char* text, std::size_t& length, const char* words) {
  while (*words) text[length++] = *words++;
}

void append(char* text, std::size_t& length, long number) {
  char digits[24];
  int n = 0;
  do digits[n++] = static_cast<char>('0' + number % 10);
  while ((number /= 10) > 0);
  while (n > 0) text[length++] = digits[--n];
}

void write_mark(int signal) {
  char text[160];
  std::size_t length = 0;
  append(text, length, "signal ");
  append(text, length, static_cast<long>(signal));
  append(text, length, " (process ");
  append(text, length, static_cast<long>(getpid()));
  append(text, length, ", ");
  append(text, length, static_cast<long>(std::time(nullptr)));
  append(text, length, ")\n");
  const int file = ::open(mark_path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0666);
  if (file < 0 || ::write(file, text, length) < 0) return;
  ::close(file);
}

void on_crash(int signal) {
  write_mark(signal);
  for (int k = 0; k < most_signals; ++k)
    if (signals[k] == signal) sigaction(signal, &before[k], nullptr);
  std::raise(signal);
}

}  // namespace

CrashMark::CrashMark(const std::string& path) {
  if (path.size() >= sizeof mark_path) return;
  path.copy(mark_path, path.size());
  mark_path[path.size()] = '\0';
  static std::vector<char> stack(1 << 16);  // one that ran over cannot serve
  stack_t own = {};
  own.ss_sp = stack.data();
  own.ss_size = stack.size();
  sigaltstack(&own, nullptr);
  struct sigaction action = {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_ONSTACK | SA_NODEFER;
  sigemptyset(&action.sa_mask);
  for (int k = 0; k < most_signals; ++k) sigaction(signals[k], &action, &before[k]);
}

CrashMark::~CrashMark() {
  if (mark_path[0] == '\0') return;
  for (int k = 0; k < most_signals; ++k) sigaction(signals[k], &before[k], nullptr);
  mark_path[0] = '\0';
}

std::string crash_mark_in(const std::string& directory) {
  const std::string path = (std::filesystem::path(directory) / crash_mark_name).string();
  try {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return "";
    const std::string text = read_text_file(path, 4096);
    return text.substr(0, text.find('\n'));
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace icebow
