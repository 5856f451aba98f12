// Text with numbers in it, as printf spells it.
#pragma once

#include <string>

namespace icebow {

std::string text(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace icebow
