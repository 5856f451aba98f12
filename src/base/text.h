// Text with numbers in it, as printf spells it.
#pragma once

#include <string>

namespace icebow {

std::string text(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

// A word of a file in quotes, for a message: what cannot be printed as "?", and no more than its beginning.
std::string excerpt(const std::string& word);

}  // namespace icebow
