// Columns of text for a terminal.
#pragma once

#include <string>
#include <vector>

namespace icebow {

// Characters of UTF-8 text, as a terminal counts columns (no wide characters in our texts).
int columns(const std::string& text);
// Cut to at most so many columns.
std::string cut(const std::string& text, int width);
// First column to the left, the others to the right; the first row is the head.
std::string text_table(const std::vector<std::vector<std::string>>& rows);
// "0:42", "1:02:03"; "--:--" where it is not finite.
std::string clock_time(double seconds);
// With so many digits behind the point; "-" where it is not finite. Beyond 1e12 to six digits, like 1e+300.
std::string decimals(double value, int digits);

}  // namespace icebow
