// Text in tables of comma-separated values.
#pragma once

#include <string>

namespace icebow {

// Quoted where RFC 4180 wants it. An apostrophe stands before text that a spreadsheet would take for a
// formula, which begins with = + - @, a tab or a carriage return: a study may come from somebody else.
std::string csv_cell(const std::string& text);

}  // namespace icebow
