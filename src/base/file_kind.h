// What stands in the place of a file.
#pragma once

#include <filesystem>
#include <string>

namespace icebow {

// Why nothing can be read at `path`, which is no file.
inline std::string why_no_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return "no such file";
  return std::filesystem::is_directory(status) ? "is a directory, and no file"
                                               : "is a pipe or a device, and no file";
}

}  // namespace icebow
