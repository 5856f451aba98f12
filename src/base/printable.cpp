#include "base/printable.h"

namespace icebow {
namespace {

unsigned char byte(const std::string& text, std::size_t k) {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
}

// Bytes of the character at k that is not to be printed; 0 where it may.
std::size_t unprintable(const std::string& text, std::size_t k) {
  const unsigned char a = byte(text, k), b = byte(text, k + 1), c = byte(text, k + 2);
  if ((a < ' ' && a != '\n' && a != '\t') || a == 0x7f) return 1;
  if (a == 0xc2 && b >= 0x80 && b <= 0x9f) return 2;  // U+0080 to U+009F
  if (a == 0xd8 && b == 0x9c) return 2;               // U+061C
  // U+200E, 200F, 202A to 202E, 2066 to 2069
  const bool direction = (b == 0x80 && (c == 0x8e || c == 0x8f || (c >= 0xaa && c <= 0xae))) ||
                         (b == 0x81 && c >= 0xa6 && c <= 0xa9);
  return a == 0xe2 && direction ? 3 : 0;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t bytes = unprintable(text, k);
    out += bytes > 0 ? '?' : text[k];
    k += bytes > 0 ? bytes : 1;
  }
  return out;
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (byte(text, end) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

}  // namespace icebow
