#include "base/plugin.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "base/errors.h"

namespace icebow {
namespace {

// Beside the program; tests and benchmarks may lie a folder below; an installed program has them in a folder
// of their own.
std::string place_of(const std::string& library) {
  std::error_code ignored;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  const auto beside = folder / library, installed = folder / ICEBOW_PLUGIN_FOLDER / library;
  for (const auto& place : {beside, installed})
    if (std::filesystem::exists(place, ignored)) return place.string();
  return (folder.parent_path() / library).string();
}

}  // namespace

void* plugin_function(const std::string& library, const std::string& function) {
  void* const handle = dlopen(place_of(library).c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const address = handle ? dlsym(handle, function.c_str()) : nullptr;
  if (address) return address;
  const char* const trouble = dlerror();
  throw RuntimeError(library + ", a part of this program that belongs beside it, cannot be used: " +
                     (trouble ? trouble : "no " + function + " in it"));
}

}  // namespace icebow
