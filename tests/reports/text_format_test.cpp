#include "reports/text/text_format.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "base/csv_cell.h"
#include "base/shell_word.h"

namespace icebow {

TEST_CASE("text becomes HTML, CSV and Markdown that says the same") {
  CHECK(html_escaped("<a href=\"x\">&'") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  CHECK(csv_cell("plain") == "plain");
  CHECK(csv_cell("a,\"b\"") == "\"a,\"\"b\"\"\"");
  // No spreadsheet takes them for formulas.
  CHECK(csv_cell("=HYPERLINK(\"x\")") == "\"'=HYPERLINK(\"\"x\"\")\"");
  for (const char* formula : {"=1", "+1", "-1", "@SUM(A1)", "\t=1"})
    CHECK(csv_cell(formula) == "'" + std::string(formula));
  CHECK(csv_cell("1=1") == "1=1");
  CHECK(csv_cell("") == "");
  CHECK(markdown_escaped("a|b*c\nd") == "a\\|b\\*c d");
}

TEST_CASE("numbers read as in print") {
  CHECK(fixed(1.005, 1) == "1.0");
  CHECK(fixed(-0.414, 2) == "\u22120.41");
  CHECK(fixed(-0.001, 2) == "0.00");
  CHECK(fixed(std::nan(""), 2) == "\u2013");
  CHECK(fixed(std::numeric_limits<double>::infinity(), 2) == "\u2013");
  CHECK(with_thousands(1234567) == "1\u202f234\u202f567");
  CHECK(with_thousands(-999) == "\u2212999");
  CHECK(duration(5.26) == "5.3\u00a0s");
  CHECK(duration(725) == "12\u00a0min");
  CHECK(duration(3600 * 3 + 60 * 12) == "3\u00a0h 12\u00a0min");
}

TEST_CASE("numbers for programs come back exactly") {
  for (const double value : {0.1, 1.0 / 3.0, 746875.00000000012, -2.5e-300, 0.0})
    CHECK(std::strtod(csv_number(value).c_str(), nullptr) == value);
  CHECK(csv_number(std::nan("")).empty());
}

TEST_CASE("JSON cannot leave its script") {
  const Json json = {{"name", "</script><!--"}, {"nan", std::nan("")}, {"bad", "\xff"}};
  const std::string text = json_for_script(json);
  CHECK(text.find('<') == std::string::npos);
  const Json back = Json::parse(text);
  CHECK(back.at("name") == "</script><!--");
  CHECK(back.at("nan").is_null());
}

TEST_CASE("base64 of known texts") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}

TEST_CASE("names are listed as one says them") {
  CHECK(listed({"a"}, 3) == "a");
  CHECK(listed({"a", "b"}, 3) == "a and b");
  CHECK(listed({"a", "b", "c"}, 3) == "a, b and c");
  CHECK(listed({"a", "b", "c", "d"}, 3) == "a, b and 2 more");
}

TEST_CASE("a word of a command line reaches the shell as it is") {
  CHECK(shell_word("studies/bows.json") == "studies/bows.json");
  CHECK(shell_word("my ship.json") == "'my ship.json'");
  CHECK(shell_word("it's; rm x") == "'it'\\''s; rm x'");
  CHECK(shell_word("") == "''");
}

}  // namespace icebow
