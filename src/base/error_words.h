// Exceptions of whatever kind: in words of a person, and whose fault they are.
#pragma once

#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "base/errors.h"

namespace icebow {

// The machine has let us down, and what was asked for is not to blame: a disk, a lock, files, memory or
// threads.
inline bool is_of_machine(const std::exception& error) {
  return dynamic_cast<const RuntimeError*>(&error) || dynamic_cast<const std::bad_alloc*>(&error) ||
         dynamic_cast<const std::system_error*>(&error);
}

// what(), but memory that is short is told as such, and the JSON library's words stand without the mark
// before them: "[json.exception.out_of_range.403] key 'a' not found" is "key 'a' not found".
inline std::string in_words(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "there is not enough memory: free some, raise the limit (ulimit -v), or work on fewer designs at "
           "once (--jobs)";
  const std::string what = error.what();
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system && system->code() == std::errc::resource_unavailable_try_again)
    return what + ": the system gives no more memory or threads (ulimit -v, ulimit -u)";
  const std::size_t end = what.rfind("[json.exception.", 0) == 0 ? what.find("] ") : std::string::npos;
  return end == std::string::npos ? what : what.substr(end + 2);
}

}  // namespace icebow
