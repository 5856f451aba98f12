// What is fuzzed as a file, in memory.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace icebow {

inline std::string memory_file(const std::string& ending, const std::uint8_t* data, std::size_t size) {
  static const std::string stem = "/dev/shm/icebow_fuzz_" + std::to_string(getpid());
  const std::string path = stem + ending;
  std::ofstream(path, std::ios::binary | std::ios::trunc).write(reinterpret_cast<const char*>(data), size);
  return path;
}

}  // namespace icebow
