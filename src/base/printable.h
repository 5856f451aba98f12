// Words from files on their way to a terminal or into a message.
#pragma once

#include <string>

namespace icebow {

// Control characters, which may command a terminal, and marks that turn the direction of writing become "?".
// Line ends and tabs stay.
std::string printable(const std::string& text);

// At most `most` bytes, then "..."; never cut within a character of UTF-8.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace icebow
