#include "base/text.h"

#include <cstdarg>
#include <cstdio>

namespace icebow {

std::string text(const char* pattern, ...) {
  std::va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  std::string result(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, pattern, arguments)), '\0');
  std::vsnprintf(result.data(), result.size() + 1, pattern, again);
  va_end(again);
  va_end(arguments);
  return result;
}

std::string excerpt(const std::string& word) {
  constexpr std::size_t most = 40;
  std::string result = word.substr(0, most);
  for (char& c : result)
    if (c < ' ' || c > '~') c = '?';
  return '"' + result + (word.size() > most ? "...\"" : "\"");
}

}  // namespace icebow
