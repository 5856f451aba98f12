// Numbers and text as a reader wants them: HTML, JSON inside a <script>, base64.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

// & < > " ' become entities: safe as text and inside a quoted attribute.
std::string html_escaped(const std::string& text);
// | and line ends do not survive in a table of Markdown.
std::string markdown_escaped(const std::string& text);
// Shortest text that reads back as the same double; empty where it is not finite.
std::string csv_number(double value);

// Fixed decimals with a true minus sign; an en dash where the value is not finite.
std::string fixed(double value, int decimals);
// Three significant digits and a prefix: "52.0 MPa", "1.30 GPa", "0.0052".
std::string engineering(double value, const std::string& unit);
std::string with_thousands(long long value);  // 1 234 567, narrow no-break spaces
std::string duration(double seconds);         // "3 h 12 min", "4.1 s"

// JSON that cannot end the <script> it stands in: every '<' is written \u003c. Bad UTF-8 is replaced, NaN is
// null.
std::string json_for_script(const Json& json);
std::string base64(const std::string& bytes);

// "a", "a and b", "a, b and c"; beyond `most` names "a, b and 4 more".
std::string capitalised(std::string words);
std::string listed(const std::vector<std::string>& names, std::size_t most);

}  // namespace icebow
