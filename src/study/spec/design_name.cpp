#include "study/spec/design_name.h"

#include <algorithm>
#include <cctype>

#include "base/printable.h"

namespace icebow {
namespace {

constexpr int most_characters = 64;
constexpr std::size_t most_bytes = 200, most_added_bytes = 20;

bool is_letter(unsigned char c) {
  return (c < 0x80 && std::isalnum(c)) || c >= 0x80;
}

}  // namespace

bool is_design_name(const std::string& name) {
  int characters = 0;
  for (const char c : name) characters += (c & 0xC0) != 0x80;  // UTF-8 continuation bytes do not count
  if (characters < 1 || characters > most_characters || name.size() > most_bytes) return false;
  if (!is_letter(static_cast<unsigned char>(name[0])) || printable(name) != name) return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter(static_cast<unsigned char>(c)) || std::string(" ._+()-").find(c) != std::string::npos;
  });
}

bool is_numbered_name(const std::string& name) {
  return name.size() > 1 && name[0] == 'd' && name.find_first_not_of("0123456789", 1) == std::string::npos;
}

bool is_stored_name(const std::string& name) {
  return !name.empty() && name.size() <= most_bytes + most_added_bytes && name[0] != '.' &&
         name.find_first_of(std::string("/\n\t\0", 4)) == std::string::npos && printable(name) == name;
}

}  // namespace icebow
