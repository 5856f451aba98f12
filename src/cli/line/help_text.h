// What the program says of itself: help, man page and completions, all from the table of commands.
#pragma once

#include <string>

#include "cli/line/arguments.h"

namespace icebow {

constexpr std::size_t help_width = 100;  // columns at most

std::string help_text();
std::string help_text(const Command& command);
// roff source of icebow(1).
std::string man_page();
// `shell` is "bash", "zsh" or "fish". Throws InputError for another word.
std::string completion_script(const std::string& shell);

// Words of `text` in lines of at most `width` columns, each begun with `indent` spaces but the first; a
// longer word keeps a line of its own.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace icebow
