// One writer for each store, and which kind of disk it is on.
#pragma once

#include <string>

namespace icebow {

// Holds an exclusive lock on a file of its own for as long as it lives; the lock goes with the process,
// however it ends. SQLite's own exclusive mode would shut out readers.
class StoreLock {
 public:
  // Throws RuntimeError naming the holder where another process has it, and where there are no locks.
  explicit StoreLock(const std::string& path);
  ~StoreLock();
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;

 private:
  int file_ = -1;
};

// Whether a process holds that lock.
bool is_locked(const std::string& path);

// SQLite's WAL shares memory between processes, which a network file system cannot do.
bool on_network_file_system(const std::string& path);

}  // namespace icebow
