// The part of a design's card that tells how its ice broke.
#include "reports/html/process_view.h"

#include <catch2/catch.hpp>

#include "reports/html/page_template.h"
#include "study/evaluate/process_json.h"

namespace icebow {
namespace {

Crack crack(CrackKind kind, double opened, double length) {
  Crack c;
  c.kind = kind;
  c.opened = opened;
  c.length = length;
  c.from_hull = 0.2;
  c.columns = 10;
  return c;
}

BreakingProcess made_up() {
  BreakingProcess p;
  p.thickness = 0.04;
  p.characteristic_length = 0.4;
  p.cracks.list = {crack(CrackKind::radial, 0.1, 0.6), crack(CrackKind::circumferential, 0.2, 1.26)};
  p.breaking_length = breaking_length(p.cracks.list);
  p.ice.volume = 0.02;
  p.ice.in_floes = 0.015;
  p.ice.dust = 0.001;
  p.ice.floes = {{0.1, 0.5, 0.2, 1.0, 1.0, 0.0}, {0.05, 0.3, 0.2, 0.5, 1.2, 0.1}};
  p.ice.channel = {{0.1, 1.0}, {0.2, 1.2}};
  p.load.peak_over_mean = 3.5;
  return p;
}

std::string process_html(const Json& result) {
  return rendered("process", {{"process", process_view(result, 25.0)}});
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the card tells cracks, sizes, load and pieces, at full scale and over h and l") {
  const Json result = {{"process", process_json(made_up())}};
  const std::string html = process_html(result);
  CHECK(holds(html,
              "Circumferential</th><td class=\"num\">1</td><td class=\"num\">31.5</td>"
              "<td class=\"num\">5.0</td>"));
  CHECK(holds(html,
              "from the hull</th><td class=\"num\">5.0</td><td class=\"num\">5.0</td>"
              "<td class=\"num\">0.50</td>"));
  CHECK(holds(html, "overlapping"));
  CHECK(holds(html, "Broken ice in floes</th><td class=\"num\">75\u00a0%"));
  CHECK(holds(html, "Advance per load cycle</th><td class=\"num\">\u2013"));  // there is none
  CHECK_FALSE(holds(html, "Where the hull's work went"));                     // no balance yet
}

TEST_CASE("a result without the breaking process has no such part") {
  CHECK(process_view({{"metrics", nullptr}}, 25.0).is_null());
  CHECK(process_view({{"process", nullptr}}, 25.0).is_null());
}

TEST_CASE("counts are of all, lists of the largest") {
  BreakingProcess p = made_up();
  for (int n = 0; n < 100; ++n) p.cracks.list.push_back(crack(CrackKind::radial, 0.3 + n, 0.01 * n));
  const Json cracks = process_json(p).at("cracks");
  CHECK(cracks.at("radial").at("count") == 101);
  REQUIRE(cracks.at("list").size() == 60);
  CHECK(cracks.at("list")[0].at("order") == 1);
  CHECK(cracks.at("list")[59].at("order") == 102);
  const Json floes = process_json(p).at("floes");
  CHECK(floes.at("through_thickness") == 1);
  CHECK(floes.at("area_m2").at("mean") == Approx(0.075));
}

}  // namespace icebow
