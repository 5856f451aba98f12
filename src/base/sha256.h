// SHA-256 (FIPS 180-4): names results by what they depend on.
#pragma once

#include <string>
#include <string_view>

namespace icebow {

// 64 lower-case hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace icebow
