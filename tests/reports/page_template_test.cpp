#include "reports/html/page_template.h"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace icebow {

TEST_CASE("a template takes its values, once, and escapes them") {
  CHECK(rendered_text("<b>{{a}}</b>{{{b}}}", {{"a", "{{b}} < & \"'"}, {"b", "<i>"}}) ==
        "<b>{{b}} &lt; &amp; &quot;&#39;</b><i>");
  CHECK(rendered_text("{{n}}", {{"n", 3}}) == "3");
}

TEST_CASE("blocks stay where their value is given, and repeat for lists") {
  const std::string text = "{{#a}}with {{a}} {{#b}}and {{b}}{{/b}}{{/a}}{{^a}}without{{/a}}";
  CHECK(rendered_text(text, {{"a", "x"}, {"b", "y"}}) == "with x and y");
  CHECK(rendered_text(text, {{"a", "x"}, {"b", ""}}) == "with x ");
  CHECK(rendered_text(text, {{"a", nullptr}, {"b", "y"}}) == "without");
  CHECK(rendered_text("{{#l}}{{n}};{{/l}}", {{"l", {{{"n", "1"}}, {{"n", "<"}}}}}) == "1;&lt;;");
  CHECK(rendered_text("{{#l}}{{.}},{{/l}}", {{"l", {"p", "q"}}}) == "p,q,");
  CHECK(rendered_text("{{#l}}x{{/l}}{{^l}}none{{/l}}", {{"l", Json::array()}}) == "none");
}

TEST_CASE("a template takes another one in") {
  const Json table = {
      {"caption", "C"}, {"columns", {"k"}}, {"rows", {{{"kind", ""}, {"label", "<"}, {"values", {"7"}}}}}};
  CHECK(rendered_text("{{> table}}", table).find("<th scope=\"row\">&lt;</th><td class=\"num\">7</td>") !=
        std::string::npos);
}

TEST_CASE("a template with a mistake is an error, not an empty place") {
  CHECK_THROWS_AS(rendered_text("{{unknown}}", Json::object()), std::logic_error);
  CHECK_THROWS_AS(rendered_text("{{#a}}open", {{"a", "1"}}), std::logic_error);
  CHECK_THROWS_AS(rendered_text("{{a", {{"a", "1"}}), std::logic_error);
  CHECK_THROWS_AS(rendered_text("{{> no_such}}", Json::object()), std::logic_error);
  CHECK_THROWS_AS(rendered("no_such", Json::object()), std::logic_error);
}

}  // namespace icebow
