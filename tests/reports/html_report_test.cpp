#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "base/errors.h"
#include "base/json.h"
#include "reports/html/html_report.h"
#include "reports/html/packed_text.h"
#include "reports/tables/table_report.h"
#include "study/store/store.h"
#include "tests/support/sample_study.h"
#include "tests/support/scratch.h"

namespace icebow {
namespace {

std::string html_of(const Scratch& study) {
  write_html_report(study.path(), study.path() + "/report.html");
  return read_text_file(study.path() + "/report.html");
}

std::string sample_html(const SampleStudy& options = {}) {
  const Scratch study("html");
  write_sample_study(study.path(), options);
  return html_of(study);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

Json data_of(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"icebow-data\">";
  const std::size_t begin = html.find(open) + open.size();
  return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

Json design_of(const Json& data, const std::string& name) {
  for (const Json& design : data.at("designs"))
    if (design.at("name") == name) return design;
  return nullptr;
}

}  // namespace

TEST_CASE("the page names every design and gives the reasons of those that are not ranked") {
  const std::string html = sample_html();
  for (const char* name : {"baseline", "Thyssen-Waas", "steep stem", "fine entrance", "White", "Melville",
                           "spoon", "high flare", "blunt", "too full", "too long", "fast water"})
    CHECK(holds(html, std::string(">") + name + "<"));
  CHECK(holds(html, "unstable at step 8120"));
  CHECK(holds(html, "g1 = -3.41 m"));
  CHECK(holds(html,
              "Thyssen-Waas (stem 14.0\u00b0, waterline 39.0\u00b0, buttock 13.0\u00b0 and flare 77.0\u00b0) "
              "has the lowest mean ice load, 0.75"));
  CHECK(holds(html, "23\u00a0\u00b1\u00a010\u00a0% below the baseline (p "));
  CHECK(count(html, "<details class=\"card\"") == 10);
}

TEST_CASE("two objectives: the front stands in the page as a list and as the chart's data") {
  SampleStudy options;
  options.pareto = true;
  const std::string html = sample_html(options);
  CHECK(holds(html, "id=\"chart-front\""));
  CHECK(holds(html, "no design surpasses Thyssen-Waas, "));
  const Json data = data_of(html);
  CHECK(data.at("second").at("unit") == "t");
  CHECK(design_of(data, "Thyssen-Waas").at("front") == "front");  // the lowest load
  CHECK(design_of(data, "blunt").at("front") == "open");        // the one larger bow has no surely lower load
  CHECK(design_of(data, "steep stem").at("front") == "front");  // the largest displacement
  CHECK_FALSE(holds(sample_html(), "id=\"chart-front\""));
}

TEST_CASE("the smallest margin of a design is one that it must keep") {
  const Json margin = design_of(data_of(sample_html()), "White").at("smallest_margin");
  CHECK(margin.at("name") == "g3");  // g2 = -0.41 is only reported
  CHECK(margin.at("value") == 1.92);
}

TEST_CASE("the page needs nothing from outside") {
  const std::string html = sample_html();
  CHECK_FALSE(std::regex_search(html, std::regex("(src|href)=\"(https?:)?//")));
  CHECK_FALSE(holds(html, "@import"));
  CHECK_FALSE(std::regex_search(html, std::regex("url\\(\"?https?:")));
}

TEST_CASE("a design's name is text wherever it stands") {
  const std::string html = sample_html();
  CHECK(holds(html, "odd &lt;b&gt;&amp;&quot;&#39;&lt;script&gt;"));
  CHECK_FALSE(holds(html, "odd <b>"));
  CHECK(count(html, "<script") == count(html, "</script>"));
  CHECK_FALSE(design_of(data_of(html), "odd <b>&\"'<script>").is_null());
}

TEST_CASE("ids are unique and references to them hold") {
  const std::string html = sample_html();
  const std::string body = html.substr(0, html.find("id=\"icebow-data\""));
  std::map<std::string, int> ids;
  const std::regex id("\\sid=\"([^\"]+)\"");
  for (std::sregex_iterator it(body.begin(), body.end(), id), end; it != end; ++it) ++ids[(*it)[1]];
  for (const auto& [name, n] : ids) {
    INFO(name);
    CHECK(n == 1);
  }
  const std::regex reference("(?:href=\"#|url\\(#)([\\w-]+)");
  for (std::sregex_iterator it(body.begin(), body.end(), reference), end; it != end; ++it) {
    INFO((*it)[1]);
    CHECK(ids.count((*it)[1]) == 1);
  }
}

TEST_CASE("the data in the page is that of the store, full scale") {
  const Json data = data_of(sample_html());
  const Json white = design_of(data, "White");
  CHECK(white.at("mean_N").get<double>() == Approx(50.3 * 25 * 25 * 25));
  CHECK(white.at("ci95_N").get<double>() == Approx(4.4 * 25 * 25 * 25));
  CHECK(white.at("steady_m") == Json::array({12.5, 62.5}));
  CHECK(white.at("histories")[0].at("advance_m").back().get<double>() == 62.49);
  CHECK(white.at("histories")[0].at("load_N").size() == 400);
  CHECK(design_of(data, "too full").at("mean_N").is_null());
}

TEST_CASE("pictures and lines plans are inside the page") {
  const std::string html = sample_html();
  CHECK(count(html, "src=\"data:image/png;base64,iVBOR") == 30 + 2);  // three of each, two animations
  CHECK(count(html, "<svg xmlns=") == 10);
  CHECK(count(html, "Content-Security-Policy") == 1);
  CHECK(count(html, "default-src 'none'; script-src 'sha256-") == 1);
  CHECK(holds(html, "62.5\u00a0m <small>(model 2.50\u00a0m)</small>"));
}

TEST_CASE("a report of a study that is still running says so") {
  SampleStudy options;
  options.finished = false;
  const std::string html = sample_html(options);
  CHECK(holds(html, "Unfinished study."));
  CHECK(holds(html, "1 design started without a result and 4 designs not started"));
  CHECK(holds(html, "\u2026 running"));
  CHECK_FALSE(holds(sample_html(), "Unfinished study."));
}

TEST_CASE("a study by the formula alone is ranked and drawn by it") {
  SampleStudy options;
  options.peridynamics = false;
  const std::string html = sample_html(options);
  CHECK(holds(html, "lowest breaking resistance by Lindqvist&#39;s formula"));
  CHECK_FALSE(holds(html, "id=\"chart-history\""));
  CHECK_FALSE(holds(html, "id=\"chart-scatter\""));
  CHECK(holds(html, "id=\"chart-loads\""));
  CHECK_FALSE(holds(html, "What the simulation includes"));
  CHECK(count(html, "<details class=\"card\"") == 10);
}

TEST_CASE("a study without the formula is ranked by its loads alone") {
  SampleStudy options;
  options.lindqvist = false;
  const std::string html = sample_html(options);
  CHECK(holds(html, "id=\"chart-loads\""));
  CHECK_FALSE(holds(html, "id=\"chart-scatter\""));
  CHECK_FALSE(holds(html, "Lindqvist&#39;s breaking part"));
}

TEST_CASE("what the study simulates is told as the study has it") {
  const Scratch study("told");
  write_sample_study(study.path(), {});
  Json document = parse_json(read_text_file(study.path() + "/study.json"), "study");
  document["water"] = {{"added_mass_m", 4.0}, {"drag", 1.2}};
  write_text_file(study.path() + "/study.json", document.dump());
  const std::string html = html_of(study);
  CHECK(holds(html, "water that moves with the ice (added mass)"));
  CHECK(holds(html, "added mass of a layer 4.0\u00a0m deep"));
  CHECK(holds(html, "drag coefficient 1.2"));
  CHECK(holds(html, "Layers through the thickness"));
  CHECK_FALSE(holds(html, "measured mean load"));
}

TEST_CASE("the breaking of the two best designs can be played") {
  const std::string html = sample_html();
  CHECK(count(html, "<details class=\"animation screen\">") == 2);
}

TEST_CASE("cards beyond the first ones wait in the data of the page") {
  const std::string html = sample_html();
  const std::size_t begin = html.find("id=\"icebow-cards\">");
  REQUIRE(begin != std::string::npos);
  const std::string none =
      "id=\"icebow-cards\">" + packed("{}") + "<";  // ten designs stand in the page whole
  CHECK(html.compare(begin, none.size(), none) == 0);
}

TEST_CASE("results with next to nothing in them still make a page") {
  const Scratch study("bare");
  {
    Store store = Store::open(study.path() + "/results.sqlite");
    Evaluation e;
    for (const EvaluationStatus status :
         {EvaluationStatus::ok, EvaluationStatus::infeasible, EvaluationStatus::failed}) {
      e.name = e.key = to_string(status);
      e.status = status;
      e.result = status == EvaluationStatus::ok ? Json{{"metrics", {{"mean_load_N", nullptr}}}, {"hull", "?"}}
                                                : Json();
      store.put(e);
    }
  }
  const std::string html = html_of(study);
  CHECK(holds(html, "No design could be ranked"));
  CHECK(holds(html, "No reason was recorded."));
}

TEST_CASE("a directory without a study is the user's mistake") {
  const Scratch empty("none");
  CHECK_THROWS_AS(write_html_report(empty.path(), empty.path() + "/report.html"), InputError);
  CHECK_THROWS_WITH(write_table_reports(empty.path()), Catch::Contains("results.sqlite"));
}

}  // namespace icebow
