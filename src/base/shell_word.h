// Words of a command line that somebody may paste.
#pragma once

#include <string>

namespace icebow {

// As a shell takes the text for one word: in quotes where it has to be.
std::string shell_word(const std::string& text);
std::string shell_quoted(const std::string& text);  // always in quotes

}  // namespace icebow
