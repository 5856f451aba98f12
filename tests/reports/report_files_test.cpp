#include <algorithm>
#include <catch2/catch.hpp>

#include "base/json.h"
#include "reports/content/history_file.h"
#include "reports/content/hull_outline.h"
#include "reports/text/inline_svg.h"
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
      "<?xml version=\"1.0\"?><svg><clipPath id=\"a\"/><g clip-path=\"url(#a)\" id='ab'/><use "
      "href=\"#ab\"/></svg>\n";
  CHECK(inline_svg(text, "d1-") ==
        "<svg><clipPath id=\"d1-a\"/><g clip-path=\"url(#d1-a)\" id='d1-ab'/><use href=\"#d1-ab\"/></svg>");
}

TEST_CASE("a drawing that would run something is left out") {
  CHECK(inline_svg("<svg><script>1</script></svg>", "d").empty());
  CHECK(inline_svg("<svg onload=\"x()\"></svg>", "d").empty());
  CHECK(inline_svg("no drawing", "d").empty());
}

TEST_CASE("the waterline of a bow is cut from its mesh") {
  const Scratch directory("outline");
  const std::string file = directory.path() + "/hull.obj";
  // Quads from z = -2 to z = 1; the surface moves 2 m forward for each metre up, so z = 0 is the formula
  // itself.
  write_text_file(file, sample_hull_obj(30.0, 20.0));
  const std::vector<Vec3> waterline = read_waterline(file);
  REQUIRE(waterline.size() == 25);
  CHECK(waterline.front()[0] == Approx(0.0).margin(1e-9));
  CHECK(waterline.front()[1] == Approx(0.0).margin(1e-9));
  CHECK(waterline.back()[0] == Approx(-20.0));
  CHECK(waterline.back()[1] == Approx(11.5));
  const std::string svg = plan_svg(waterline, 25.0, 2.0);
  CHECK(svg.find("L50.0,23.0") != std::string::npos);  // the stem, at the right end, on the centre line
  CHECK(svg.find("L10.0,0.0") != std::string::npos);   // the shoulder, 20 m aft of it, at half the beam
}

TEST_CASE("a file that is no mesh gives no waterline") {
  const Scratch directory("nomesh");
  const std::string file = directory.path() + "/hull.obj";
  write_text_file(file, "v 0 0 0\nf 1 2 3\n");
  CHECK(read_waterline(file).empty());
  CHECK(read_waterline(directory.path() + "/missing.obj").empty());
  CHECK(plan_svg({}, 10.0, 1.0).empty());
}

}  // namespace icebow
