// A folder that all ranks of a test share.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/communicator.h"

namespace icebow {

// One for all ranks of a test; the root makes and removes it.
class TestFolder {
 public:
  TestFolder(const Communicator& comm, const std::string& name) : comm_(comm) {
    const std::string own = comm.broadcast(std::to_string(::getpid()));  // others may run the same test
    path_ = std::filesystem::temp_directory_path() / ("icebow_" + name + "_" + own);
    if (comm_.is_root()) {
      std::filesystem::remove_all(path_);
      std::filesystem::create_directories(path_);
    }
    comm_.barrier();
  }
  ~TestFolder() {
    comm_.barrier();
    if (comm_.is_root()) std::filesystem::remove_all(path_);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }

 private:
  const Communicator& comm_;
  std::filesystem::path path_;
};

}  // namespace icebow
