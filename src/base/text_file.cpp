#include "base/text_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/errors.h"

namespace icebow {
namespace {

// A file that is made here or not at all: what somebody put in its place, a link for one, is taken away.
int made_anew(const std::string& path) {
  const auto make = [&] {
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  };
  const int file = make();
  if (file >= 0 || errno != EEXIST) return file;
  return ::unlink(path.c_str()) == 0 ? make() : -1;
}

constexpr int patience_ms = 5000;

// Of a pipe, which would keep us waiting for ever; from then on it is waited for as usual.
bool somebody_writes(int file) {
  struct stat kind = {};
  const bool pipe = ::fstat(file, &kind) == 0 && S_ISFIFO(kind.st_mode);
  pollfd wait = {file, POLLIN, 0};
  if (pipe && ::poll(&wait, 1, patience_ms) <= 0) return false;
  ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return true;
}

bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(file, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  return ::fsync(file) == 0 || errno == EINVAL;  // not every file system has it
}

}  // namespace

void write_text_file(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".tmp" + std::to_string(::getpid());
  const auto fail = [&](const char* doing) {
    const std::string why = std::strerror(errno);
    std::remove(temporary.c_str());
    throw RuntimeError("cannot " + std::string(doing) + " " + path + ": " + why);
  };
  const int file = made_anew(temporary);
  if (file < 0) fail("write");
  const bool written = write_all(file, text);
  const int error = errno;
  const bool closed = ::close(file) == 0;  // a quota on a network file system may speak up here first
  if (!written) errno = error;
  if (!written || !closed) fail("write");
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail("replace");
}

std::string read_text_file(const std::string& path, std::uint64_t most) {
  const auto fail = [&](const std::string& why) { throw InputError("cannot read " + path + ": " + why); };
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) fail(std::strerror(errno));
  if (!somebody_writes(file)) {
    ::close(file);
    fail("it is a pipe to which nobody has written for " + std::to_string(patience_ms / 1000) + " s");
  }
  std::string text;
  char buffer[1 << 16];
  ssize_t n = 0;
  while ((n = ::read(file, buffer, sizeof buffer)) != 0) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 || text.size() + static_cast<std::size_t>(n) > most) break;
    text.append(buffer, static_cast<std::size_t>(n));
  }
  const int error = errno;
  ::close(file);
  if (n < 0) fail(std::strerror(error));
  if (n > 0) fail("it has more than " + std::to_string(most) + " bytes");
  return text;
}

}  // namespace icebow
