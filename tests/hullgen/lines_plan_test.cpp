#include "hullgen/lines_plan.h"

#include <catch2/catch.hpp>
#include <regex>

#include "hullgen/svg_canvas.h"
#include "paper_bows.h"

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

TEST_CASE("a label that would cover another moves or is left out") {
  SvgCanvas svg(100, 100, "c", "", "t");
  CHECK(svg.label({50, 50}, "one", Anchor::middle, "n"));
  CHECK_FALSE(svg.label({52, 50}, "two", Anchor::middle, "n"));
  CHECK(svg.label({52, 50}, "three", Anchor::middle, "n", {{0, -20}}));
  CHECK(svg.svg().find("two") == std::string::npos);
  CHECK(svg.svg().find("y=\"30.0\"") != std::string::npos);
}
