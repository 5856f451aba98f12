#include <algorithm>
#include <catch2/catch.hpp>

#include "base/json.h"
#include "hullgen/bow/bow.h"
#include "hullgen/bow/family.h"
#include "hullgen/bow/make_hull.h"
#include "hullgen/drawing/lines_plan.h"
#include "reports/content/history_file.h"
#include "reports/content/hull_outline.h"
#include "reports/content/inline_svg.h"
#include "tests/support/sample_files.h"
#include "tests/support/scratch.h"

namespace icebow {

TEST_CASE("a load record is found by its column names and scaled") {
  const Scratch directory("history");
  const std::string file = directory.path() + "/history.csv";
  write_text_file(file, "Fx_N,time_s,advance_m\n-10,0.1,0.5\n4,0.2,1\nbroken,0.3,1.5\n-1,0.4\n-20,0.5,2\r\n");
  const LoadSeries series = read_load_series(file, 25.0, 100.0);
  CHECK(series.advance == std::vector<double>{12.5, 25.0, 50.0});
  CHECK(series.load == std::vector<double>{1000.0, -400.0, 2000.0});
  CHECK(read_load_series(directory.path() + "/missing.csv", 1, 1).load.empty());
}

TEST_CASE("a thinned record keeps its peaks and its order") {
  LoadSeries series;
  for (int i = 0; i < 10000; ++i) {
    series.advance.push_back(i);
    series.load.push_back(i == 4321 ? 99.0 : i == 77 ? -5.0 : i % 7);
  }
  const LoadSeries thin = thinned(series, 200);
  CHECK(thin.load.size() <= 200);
  CHECK(*std::max_element(thin.load.begin(), thin.load.end()) == 99.0);
  CHECK(*std::min_element(thin.load.begin(), thin.load.end()) == -5.0);
  CHECK(std::is_sorted(thin.advance.begin(), thin.advance.end()));
  CHECK(thinned(series, 20000).load.size() == 10000);
}

TEST_CASE("two drawings with the same ids share a page") {
  const std::string text =
      "<?xml version=\"1.0\"?><svg><clipPath id=\"a\"/><g clip-path=\"url(#a)\" id='ab'/><title id=\"t\">1 "
      "&lt; 2</title>"
      "</svg>\n";
  CHECK(inline_svg(text, "d1-") ==
        "<svg><clipPath id=\"d1-a\"/><g clip-path=\"url(#d1-a)\" id=\"d1-ab\"/><title id=\"d1-t\">1 &lt; "
        "2</title></svg>");
}

TEST_CASE("a drawing that would run or load something is left out") {
  for (const char* inside : {"<script>1</script>", "<a href=\"javascript:x()\"><text>t</text></a>",
                             "<foreignObject><p/></foreignObject>", "<g onclick=\"x()\"/>",
                             "<g OnClick = 'x()'/>", "<image href=\"http://x/y.png\"/>", "<use href=\"#a\"/>",
                             "<animate attributeName=\"href\" values=\"javascript:x()\"/>", "<set/>",
                             "<svg:script/>", "<iframe/>", "<title><img/></title>", "<SCRIPT/>"})
    CHECK(inline_svg(std::string("<svg>") + inside + "</svg>", "d") == "");
  CHECK(inline_svg("<svg onload=\"x()\"></svg>", "d").empty());
  CHECK(inline_svg("<html><svg/></html>", "d").empty());
  CHECK(inline_svg("no drawing", "d").empty());
  CHECK(inline_svg("<svg><g>", "d").empty());
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<g>";
  CHECK(inline_svg("<svg>" + deep + "</svg>", "d").empty());
}

TEST_CASE("what is not on the list of a drawing's attributes is dropped, and entities stay what they are") {
  const auto of = [](const std::string& attribute) {
    return inline_svg("<svg><path " + attribute + "/></svg>", "d-");
  };
  for (const char* attribute :
       {"style=\"background:url(http://x)\"", "fill=\"url(http://x)\"", "stroke=\"url(#a)\"", "href=\"#a\"",
        "xlink:href=\"http://x\"", "clip-path=\"url(http://x)\"", "clip-path=\"url(#a) url(http://x)\"",
        "class=\"page lightbox\"", "xmlns=\"http://x\"", "id=\"a&quot; onload=&quot;x()\"",
        "d=\"&lt;script&gt;\"", "filter=\"url(#a)\"", "data-x=\"1\""})
    CHECK(of(attribute) == "<svg><path/></svg>");
  CHECK(of("class=\"dwl page\" d=\"M0 0L1 1\"") == "<svg><path class=\"dwl\" d=\"M0 0L1 1\"/></svg>");
  CHECK(inline_svg("<!DOCTYPE svg [<!ENTITY a \"<script/>\">]><svg><text>&a;</text></svg>", "d") ==
        "<svg><text>&amp;a;</text></svg>");
  CHECK(inline_svg("<svg><text><![CDATA[</text><script>1</script>]]></text></svg>", "d") ==
        "<svg><text>&lt;/text&gt;&lt;script&gt;1&lt;/script&gt;</text></svg>");
}

TEST_CASE("an attribute of any length is read in one go") {
  const std::string path(300000, '1');
  CHECK(inline_svg("<svg><path d=\"" + path + "\" id=\"" + path + "\"/></svg>", "d") ==
        "<svg><path d=\"" + path + "\"/></svg>");
}

TEST_CASE("a lines plan of ours stays whole, with the program's own style") {
  BowParameters bow = preset_bow(BowFamily::flat);
  bow.panel = bow.B / 10.0;
  const std::string file = lines_plan_svg(make_hull(bow), bow, "A < B");
  const std::string drawn = inline_svg(file, "d1-");
  const auto count = [](const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
    return n;
  };
  for (const char* element : {"<path", "<text", "<circle", "class=\"", "viewBox", "d=\""})
    CHECK(count(drawn, element) == count(file, element));
  CHECK(count(drawn, "<style") + count(drawn, "stroke-width=") == 0);  // drawings_style() has it once
  CHECK(drawings_style().find(".lines-plan path.dwl{stroke:var(--lp-water") != std::string::npos);
  std::string hostile = file;
  hostile.replace(hostile.find("<style>"), 7, "<style>body{display:none}");
  CHECK(inline_svg(hostile, "d1-") == drawn);
}

TEST_CASE("the waterline of a bow is cut from its mesh") {
  const Scratch directory("outline");
  const std::string file = directory.path() + "/hull.obj";
  // Quads from z = -2 to z = 1; the surface moves 2 m forward for each metre up, so z = 0 is the formula
  // itself.
  write_text_file(file, sample_hull_obj(30.0, 20.0));
  const std::vector<Vec3> waterline = read_waterline(file);
  REQUIRE(waterline.size() == 25);
  constexpr double rounding = 1e-9;  // m: of the cut through a panel
  CHECK(waterline.front()[0] == Approx(0.0).margin(rounding));
  CHECK(waterline.front()[1] == Approx(0.0).margin(rounding));
  CHECK(waterline.back()[0] == Approx(-20.0));
  CHECK(waterline.back()[1] == Approx(11.5));
  const std::string svg = bow_outline(waterline, 25.0, 2.0).path;
  CHECK(svg.find("L50.0,23.0") != std::string::npos);  // the stem, at the right end, on the centre line
  CHECK(svg.find("L10.0,0.0") != std::string::npos);   // the shoulder, 20 m aft of it, at half the beam
}

TEST_CASE("a file that is no mesh gives no waterline") {
  const Scratch directory("nomesh");
  const std::string file = directory.path() + "/hull.obj";
  write_text_file(file, "v 0 0 0\nf 1 2 3\n");
  CHECK(read_waterline(file).empty());
  CHECK(read_waterline(directory.path() + "/missing.obj").empty());
  CHECK(bow_outline({}, 10.0, 1.0).path.empty());
}

}  // namespace icebow
