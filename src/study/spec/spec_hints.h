// Words that help a person mend an input: the nearest known name, numbers as one would write them.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

// Letters to insert, delete, change or swap (neighbours) to get from one word to the other.
int edit_distance(const std::string& a, const std::string& b);
// The known word closest to `word`, small letters and capitals taken for the same, or the one that others
// call `word` ("lhs"); empty where none resembles it.
std::string nearest(const std::string& word, const std::vector<std::string>& known);
// " (did you mean "x"?)" or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);
// " (write 24.35)" where `text` is a number with a decimal comma or in quotes; else nothing.
std::string number_meant(const std::string& text);
std::string number_meant_by(const Json& value);  // the same of a text; nothing of any other value
// Shortest text that reads back as the number to six digits: 0.04, 2e-05, 1.3e+09.
std::string brief(double value);
std::string listed(const std::vector<std::string>& words);  // "a, b, c"

}  // namespace icebow
