#include "reports/html/html_cycle.h"

#include <cmath>

#include "base/json_fields.h"
#include "reports/text/text_format.h"

namespace icebow {
namespace {

std::string row(const std::string& name, const std::string& value) {
  return "<tr><th scope=\"row\">" + name + "</th><td class=\"num\">" + value + "</td></tr>";
}

}  // namespace

std::string cycle_html(const RankedDesign& ranked, const DesignContent& design, const LoadUnit& unit) {
  const Json& cycle = part_at(ranked.evaluation.result, "/cycle");
  if (!std::isfinite(number_at(cycle, "/mean_load_N"))) return {};
  const auto load = [&](const char* key) {
    return fixed(number_at(cycle, key) / unit.newtons, unit.decimals);
  };
  const auto interval = [&](double value, double half) {
    return with_interval(value / unit.newtons, half / unit.newtons, unit.decimals);
  };
  std::string rows = row("Mean \u00b1 95\u00a0%", interval(ranked.cycle_load, ranked.cycle_ci95));
  rows += row("Crushing", load("/crushing_N")) + row("Bending", load("/bending_N")) +
          row("Friction", load("/friction_N"));
  rows += row("Submersion", load("/submersion_N")) + row("Water", load("/water_N"));
  if (std::isfinite(ranked.solver_load))
    rows += row("Simulated", interval(ranked.solver_load, ranked.solver_ci95));
  if (std::isfinite(ranked.difference_ci95))
    rows += row("Corrected by simulation / cycle", interval(ranked.mean_load, ranked.mean_load_ci95));
  std::string html =
      "<div class=\"tables\"><div><table><caption>Breaking cycle</caption><thead><tr><th></th><th "
      "scope=\"col\">full scale, " +
      unit.name + "</th></tr></thead><tbody>" + rows + "</tbody></table></div></div>\n";
  if (design.voyage.empty()) return html;
  return html + "<figure><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"A voyage\">" +
         design.voyage +
         "</div><figcaption>The end of a voyage by the breaking cycle, full scale: pieces as seen from "
         "above, and the "
         "load.</figcaption></figure>\n";
}

}  // namespace icebow
