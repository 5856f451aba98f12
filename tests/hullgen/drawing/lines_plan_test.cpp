#include "hullgen/drawing/lines_plan.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <map>
#include <regex>

#include "base/units.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/drawing/svg_canvas.h"
#include "tests/support/paper_bows.h"

using namespace icebow;

namespace {

int count(const std::string& words, const std::string& part) {
  int n = 0;
  for (std::size_t at = words.find(part); at != std::string::npos; at = words.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("the lines plan names dimensions, the four measured angles and is one self-contained element") {
  for (const BowParameters& bow : {conventional_bow(), thyssen_waas_bow()}) {
    const std::string svg = lines_plan_svg(make_hull(bow), bow, "A <bow> & more");
    CHECK(svg.rfind("<svg ", 0) == 0);
    CHECK(svg.find("</svg>") == svg.size() - 7);
    CHECK(svg.find("A &lt;bow&gt; &amp; more") != std::string::npos);
    CHECK(svg.find("href") == std::string::npos);
    CHECK(svg.find(" id=") == std::string::npos);  // several drawings share one page
    CHECK(svg.find("nan") == std::string::npos);
    for (const char* name : {"stem", "waterline", "buttock", "flare"})
      CHECK(std::regex_search(svg,
                              std::regex("class=\"angle\"[^>]*>" + std::string(name) + " [0-9.]+\u00b0<")));
    CHECK(count(svg, "class=\"arc\"") == 4);
    CHECK(count(svg, "class=\"buttock\"") >= 3);
    CHECK(count(svg, "class=\"waterline\"") >= 4);
    CHECK(count(svg, "class=\"station\"") >= 8);
    CHECK(count(svg, "class=\"dwl-cut\"") == 1);
    CHECK(svg.size() < 40000);
  }
}

TEST_CASE("a bow without a hull says why it has no lines") {
  BowParameters bow = conventional_bow();
  bow.Lf = 20.0;
  const std::string svg = lines_plan_svg(make_hull(bow), bow, "Short");
  CHECK(svg.find("raise the bow length Lf") != std::string::npos);
}

TEST_CASE(
    "two hulls in one plan: both names, the angles of both, the second's lines in a group of their own") {
  const BowParameters first = conventional_bow(), second = thyssen_waas_bow();
  const Hull a = make_hull(first), b = make_hull(second);
  const std::string svg = overlaid_lines_plan_svg({a, first, "One & only"}, {b, second, "Other"}, "Both");
  CHECK(svg.find("One &amp; only: ") != std::string::npos);
  CHECK(svg.find("Other: ") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(count(svg, "<g class=\"second\">") == 4);  // legend and three views
  CHECK(count(svg, "</g>") == 4);
  for (const BowAngles& angles : {first.angles, second.angles})
    for (double angle : {angles.stem, angles.waterline, angles.buttock, angles.flare}) {
      char words[32];
      std::snprintf(words, sizeof words, ">%.2f<", degrees(angle));
      CHECK(svg.find(words) != std::string::npos);
    }
  CHECK(count(svg, "class=\"dwl-cut\"") == 2);
  // Of a hull over itself every line is there twice, in the same place.
  const std::string twice = overlaid_lines_plan_svg({a, first, "A"}, {a, first, "A"}, "A");
  const std::regex waterline("class=\"waterline\" d=\"([^\"]*)\"");
  std::map<std::string, int> drawn;
  for (std::sregex_iterator it(twice.begin(), twice.end(), waterline), end; it != end; ++it)
    ++drawn[(*it)[1]];
  REQUIRE(drawn.size() >= 4);
  for (const auto& line : drawn) CHECK(line.second == 2);
}

TEST_CASE("for print there are no CSS variables, on a screen there are") {
  const BowParameters bow = conventional_bow();
  const Hull hull = make_hull(bow);
  const std::string print = lines_plan_svg(hull, bow, "A", DrawnFor::print);
  for (const char* word : {"var(", "currentColor", "$", "@media"})
    CHECK(print.find(word) == std::string::npos);
  const std::string screen = lines_plan_svg(hull, bow, "A");
  CHECK(screen.find("var(--lp-second,") != std::string::npos);
  CHECK(screen.find("$") == std::string::npos);
}

TEST_CASE("a reader without CSS sees the colours too") {
  const BowParameters bow = conventional_bow();
  const Hull hull = make_hull(bow);
  const std::string plan = overlaid_lines_plan_svg({hull, bow, "A"}, {hull, bow, "B"}, "Both");
  const auto all = [&](const std::string& kind, const std::string& attribute) {
    const std::regex element("<" + kind + "[^>]*>");
    int n = 0, with = 0;
    for (std::sregex_iterator it(plan.begin(), plan.end(), element), end; it != end; ++it, ++n)
      with += (*it)[0].str().find(attribute) != std::string::npos;
    return n > 0 && n == with;
  };
  CHECK(all("path", " stroke=\"#"));
  CHECK(all("text", " fill=\"#"));
  CHECK(all("path class=\"dwl-cut\"", " stroke=\"#2485c7\"") ==
        false);  // the second hull's is its own colour
  CHECK(count(plan, "stroke=\"#2485c7\" stroke-width=\"2\"") == 1);
  CHECK(all("path class=\"arc\"", " stroke=\"#d4572a\" stroke-width=\"1.6\""));
  CHECK(all("path class=\"grid\"", " stroke-opacity=\".22\""));
  CHECK(count(plan, "stroke=\"#8e44ad\"") > 10);
  // What stands over the attributes is for readers that know variables.
  CHECK(plan.find("@supports (color: var(--a)) {") == plan.find("<style>") + 7);
  CHECK(plan.find("}\n}\n</style>") != std::string::npos);
  CHECK(count(plan, "fill=\"none\"") == 1);  // of the drawing itself
}

TEST_CASE("a label keeps off lines where it can, and off other labels always") {
  const SvgStyle plain("c", {});
  SvgCanvas svg(100, 100, plain, "t");
  svg.line({0, 48}, {100, 46}, "buttock");
  svg.line({0, 80}, {100, 80}, "grid");  // may be covered
  CHECK(svg.label({50, 50}, "one", Anchor::middle, "n", {{0, 5}, {0, 33}}));
  CHECK(svg.svg().find("y=\"83.0\"") != std::string::npos);
  CHECK(svg.label({50, 50}, "two", Anchor::middle, "n", {{0, 33}}));
  CHECK(svg.svg().find("y=\"50.0\"") != std::string::npos);
}

TEST_CASE("a label that would cover another moves or is left out") {
  const SvgStyle plain("c", {});
  SvgCanvas svg(100, 100, plain, "t");
  CHECK(svg.label({50, 50}, "one", Anchor::middle, "n"));
  CHECK_FALSE(svg.label({52, 50}, "two", Anchor::middle, "n"));
  CHECK(svg.label({52, 50}, "three", Anchor::middle, "n", {{0, -20}}));
  CHECK(svg.svg().find("two") == std::string::npos);
  CHECK(svg.svg().find("y=\"30.0\"") != std::string::npos);
}
