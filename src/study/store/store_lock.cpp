#include "study/store/store_lock.h"

#include <fcntl.h>  // F_OFD_SETLK: g++ defines _GNU_SOURCE
#include <sys/file.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "base/errors.h"
#include "study/evaluate/provenance.h"

namespace icebow {
namespace {

std::string content(int file) {
  char text[256];
  const ssize_t n = pread(file, text, sizeof text - 1, 0);
  std::string line(text, n > 0 ? static_cast<std::size_t>(n) : 0);
  return line.substr(0, line.find('\n'));
}

// Of the whole file, by the kernel's table of locks or, where a network file system refuses that, by the
// server's. Either goes with the process. 0 or an errno.
int lock_once(int file) {
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return 0;
  if (errno == EWOULDBLOCK) return EWOULDBLOCK;
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file, F_OFD_SETLK, &whole) == 0) return 0;
  return errno == EACCES ? EWOULDBLOCK : errno;
}

// 0 or an errno. Tries for a while: a run that was killed while it started a child shares its lock with that
// child until the child has become another program.
int lock(int file) {
  int error = EWOULDBLOCK;
  for (int i = 0; i < 50 && error == EWOULDBLOCK; ++i) {
    if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    error = lock_once(file);
  }
  return error;
}

void write_holder(int file) {
  const std::string holder = "process " + std::to_string(getpid()) + " on " + host_name() + "\n";
  // Only words for a message: a full disk may leave them out.
  if (ftruncate(file, 0) == 0 && pwrite(file, holder.data(), holder.size(), 0) < 0) return;
}

}  // namespace

StoreLock::StoreLock(const std::string& path) {
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file_ < 0) throw RuntimeError(path + ": cannot be opened for writing: " + std::strerror(errno));
  const int error = lock(file_);
  if (error == 0) {
    write_holder(file_);
    return;
  }
  const std::string holder = content(file_);
  ::close(file_);
  if (error != EWOULDBLOCK)
    throw RuntimeError(
        path + ": cannot be locked (" + std::strerror(error) +
        "), so a second run could not be kept from this study: choose a directory on a file system "
        "with locks");
  throw RuntimeError(path + ": another icebow run is working on this study (" +
                     (holder.empty() ? std::string("holder unknown") : holder) +
                     "); wait for it, stop it, or choose another directory");
}

StoreLock::~StoreLock() {
  ::close(file_);
}

bool is_locked(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return false;
  const bool locked = lock_once(file) == EWOULDBLOCK;
  ::close(file);
  return locked;
}

bool on_network_file_system(const std::string& path) {
  // Magic numbers of statfs(2): NFS, SMB, CIFS, SMB2, Lustre, GPFS, BeeGFS, Ceph, 9P, AFS, FUSE (sshfs and
  // others).
  constexpr std::array<unsigned long, 11> network = {0x6969,     0x517b,     0xff534d42, 0xfe534d42,
                                                     0x0bd00bd0, 0x47504653, 0x19830326, 0x00c36400,
                                                     0x01021997, 0x5346414f, 0x65735546};
  struct statfs info = {};
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  if (statfs(folder.c_str(), &info) != 0) return false;
  const auto type = static_cast<unsigned long>(info.f_type) & 0xffffffffUL;
  for (const unsigned long magic : network) {
    if (type == magic) return true;
  }
  return false;
}

}  // namespace icebow
