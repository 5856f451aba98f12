#include "reports/html/page_template.h"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace icebow {

TEST_CASE("a template takes its values, once") {
  CHECK(filled("<b>{{a}}</b>{{b}}", {{"a", "{{b}}"}, {"b", "2"}}) == "<b>{{b}}</b>2");
}

TEST_CASE("blocks stay where their value is given") {
  const std::string text = "{{#a}}with {{a}} {{#b}}and {{b}}{{/b}}{{/a}}{{^a}}without{{/a}}";
  CHECK(filled(text, {{"a", "x"}, {"b", "y"}}) == "with x and y");
  CHECK(filled(text, {{"a", "x"}, {"b", ""}}) == "with x ");
  CHECK(filled(text, {{"a", ""}, {"b", "y"}}) == "without");
}

TEST_CASE("a template with a mistake is an error, not an empty place") {
  CHECK_THROWS_AS(filled("{{unknown}}", {}), std::logic_error);
  CHECK_THROWS_AS(filled("{{#a}}open", {{"a", "1"}}), std::logic_error);
  CHECK_THROWS_AS(filled("{{a", {{"a", "1"}}), std::logic_error);
}

}  // namespace icebow
