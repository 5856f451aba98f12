#include "base/text_encoding.h"

namespace icebow {

std::string why_no_text(const std::string& text) {
  const std::string begin = text.substr(0, 4);
  if (begin == std::string("\xff\xfe\0\0", 4) || begin == std::string("\0\0\xfe\xff", 4))
    return "is UTF-32 text; save it as UTF-8";
  if (begin.rfind("\xff\xfe", 0) == 0 || begin.rfind("\xfe\xff", 0) == 0)
    return "is UTF-16 text; save it as UTF-8";
  const std::size_t zero = text.find('\0');
  if (zero == std::string::npos) return "";
  return "has a zero byte, byte " + std::to_string(zero + 1) +
         ", as binary files and UTF-16 text do; save it as UTF-8 text";
}

}  // namespace icebow
