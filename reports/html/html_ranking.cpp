#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "base/text.h"
#include "reports/html/html_sections.h"
#include "reports/tables/table_report.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

const char* const angle_names[] = {"stem", "waterline", "buttock", "flare"};

struct Range {
  double lower = INFINITY, upper = -INFINITY;
  void add(double value) {
    if (!std::isfinite(value)) return;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
};

Range angle_range(const ReportContent& content, const char* angle) {
  Range range;
  for (const RankedDesign& row : content.study.ranking.rows)
    if (row.rank > 0) range.add(measured_or_requested(row.evaluation.result, angle));
  return range;
}

std::string plain(double value, int decimals) {
  return text("%.*f", decimals, value);
}

// A cell that sorts by its number; unknown numbers sort last.
std::string cell(double sort_value, const std::string& html, const char* css_class = "num") {
  const std::string key = std::isfinite(sort_value) ? csv_number(sort_value) : "";
  return "<td class=\"" + std::string(css_class) + "\" data-sort=\"" + key + "\">" + html + "</td>";
}

// The angle, and where it lies between the lowest and the highest of the study.
std::string angle_cell(double value, const Range& range) {
  std::string html = fixed(value, 1);
  if (range.upper - range.lower > 0.5 && std::isfinite(value))
    html += "<span class=\"place\"><i style=\"left:" +
            plain(100.0 * (value - range.lower) / (range.upper - range.lower), 0) + "%\"></i></span>";
  return cell(value, html, "num angle");
}

// Bar to the mean (to Lindqvist's value where nothing was simulated), whiskers over the interval, a diamond
// at Lindqvist's value. `full` newtons fill the width.
std::string load_bar(const RankedDesign& row, double full) {
  const double length = std::isfinite(row.mean_load) ? row.mean_load : row.lindqvist;
  if (!std::isfinite(length) || full <= 0.0) return {};
  const auto x = [&](double load) { return plain(std::clamp(100.0 * load / full, 0.0, 100.0), 1) + "%"; };
  std::string svg =
      "<svg class=\"loadbar\" aria-hidden=\"true\"><rect class=\"bar\" y=\"6\" height=\"10\" width=\"" +
      x(length) + "\"/>";
  if (std::isfinite(row.mean_load_ci95)) {
    const std::string from = x(row.mean_load - row.mean_load_ci95),
                      to = x(row.mean_load + row.mean_load_ci95);
    svg += "<line class=\"ci\" y1=\"11\" y2=\"11\" x1=\"" + from + "\" x2=\"" + to + "\"/>";
    for (const std::string& end : {from, to})
      svg += "<line class=\"ci\" y1=\"7\" y2=\"15\" x1=\"" + end + "\" x2=\"" + end + "\"/>";
  }
  if (std::isfinite(row.lindqvist))
    svg += "<svg x=\"" + x(row.lindqvist) +
           "\" overflow=\"visible\"><path class=\"lindqvist\" d=\"M0 7l4 4-4 4-4-4z\"/></svg>";
  return svg + "</svg>";
}

double largest_load(const Ranking& ranking) {
  double largest = 0.0;
  for (const RankedDesign& row : ranking.rows)
    for (const double load :
         {row.mean_load + (std::isfinite(row.mean_load_ci95) ? row.mean_load_ci95 : 0.0), row.lindqvist})
      if (row.rank > 0 && std::isfinite(load)) largest = std::max(largest, load);
  return 1.05 * largest;
}

std::string tie_chips(const RankedDesign& row) {
  const auto chip = [](int rank) {
    return "<span class=\"chip\" title=\"Interval overlaps that of rank " + std::to_string(rank) +
           "\">\u2248\u2009" + std::to_string(rank) + "</span> ";
  };
  std::string html;
  if (row.tied_with_best && row.rank > 1) html += chip(1);
  if (row.tied_with_next) html += chip(row.rank + 1);
  return html;
}

std::string mean_cell(const RankedDesign& row, const LoadUnit& unit) {
  const Json& result = row.evaluation.result;
  const double model = number_at(result, result_key::model_mean_load);
  std::string html =
      with_interval(row.mean_load / unit.newtons, row.mean_load_ci95 / unit.newtons, unit.decimals);
  // The breaking cycle sails at full scale: it has no model's load.
  if (std::isfinite(model) && model != number_at(result, result_key::mean_load))
    html += "<small>" + with_interval(model, number_at(result, result_key::model_mean_load_ci95), 1) +
            " N</small>";
  return cell(row.mean_load, html, "num strong");
}

std::string table_row(const ReportContent& content, std::size_t i, const Range ranges[4], double full) {
  const RankedDesign& row = content.row(i);
  const DesignContent& design = content.designs[i];
  const LoadUnit& unit = content.unit;
  const std::string& name = row.evaluation.name;
  std::string html = row.rank == 1        ? "<tr class=\"best\">"
                     : row.tied_with_best ? "<tr class=\"tied\">"
                                          : "<tr>";
  html += cell(row.rank, std::to_string(row.rank), "num rank");
  html += "<th scope=\"row\" data-sort=\"" + html_escaped(name) + "\"><a href=\"#" + design.id + "\">" +
          plan_svg(design.waterline, content.bow_length, content.bow_scale) + "<span>" + html_escaped(name) +
          "</span></a></th>";
  for (int k = 0; k < 4; ++k)
    html += angle_cell(measured_or_requested(row.evaluation.result, angle_names[k]), ranges[k]);
  if (content.has_loads()) html += mean_cell(row, unit);
  html += "<td class=\"barcell\">" + load_bar(row, full) + "</td>";
  const auto load_cell = [&](double load) { return cell(load, fixed(load / unit.newtons, unit.decimals)); };
  if (content.has_loads()) html += load_cell(number_at(row.evaluation.result, result_key::max_load));
  if (content.has_lindqvist()) html += load_cell(row.lindqvist);
  if (content.has_loads() && content.has_lindqvist()) html += cell(row.ratio, fixed(row.ratio, 2));
  if (content.has_loads()) html += "<td class=\"ties\">" + tie_chips(row) + "</td>";
  return html + "</tr>\n";
}

// On paper the label stands in for the button, which browsers leave out where they repeat a heading on the
// next page.
std::string heading(const std::string& label, const std::string& unit, const char* css_class = "num") {
  return "<th scope=\"col\" class=\"" + std::string(css_class) +
         "\"><button type=\"button\" class=\"sort\">" + label +
         "</button><span class=\"paper\" aria-hidden=\"true\">" + label + "</span>" +
         (unit.empty() ? "" : "<small>" + unit + "</small>") + "</th>";
}

std::string table_head(const ReportContent& content) {
  const std::string& unit = content.unit.name;
  const double full = largest_load(content.study.ranking) / content.unit.newtons;
  std::string html = "<thead><tr>" + heading("Rank", "") + heading("Design", "", "text");
  for (const char* label : {"Stem", "Water\u00adline", "Buttock", "Flare"})
    html += heading(label, "deg", "num angle");
  if (content.has_loads()) html += heading("Mean load \u00b1 95\u00a0%", unit + ", model N");
  html += "<th scope=\"col\" class=\"scale\"><span>0</span><span>" + fixed(full, 2) + "\u00a0" + unit +
          "</span></th>";
  if (content.has_loads()) html += heading("Peak", unit);
  if (content.has_lindqvist())
    html += heading("Lindqvist", compared_part(content.study.ranking) + ", " + unit);
  if (content.has_loads() && content.has_lindqvist()) html += heading("Ratio", "mean / L.");
  if (content.has_loads()) html += "<th scope=\"col\">Tied<small>with rank</small></th>";
  return html + "</tr></thead>\n";
}

std::string status_label(EvaluationStatus status) {
  switch (status) {
    case EvaluationStatus::infeasible:
      return "<span class=\"status\">\u25b3 infeasible</span>";
    case EvaluationStatus::failed:
      return "<span class=\"status\">\u2715 failed</span>";
    case EvaluationStatus::damaged:
      return "<span class=\"status\">\u2715 damaged</span>";
    case EvaluationStatus::running:
      return "<span class=\"status\">\u2026 running</span>";
    case EvaluationStatus::ok:
      break;
  }
  return "<span class=\"status\">not ranked</span>";
}

std::string reason_of(const Evaluation& e) {
  if (!e.reason.empty()) return html_escaped(e.reason);
  if (e.status == EvaluationStatus::running) return "Started; no result yet.";
  if (e.status == EvaluationStatus::ok) return "The result holds no value to rank by.";
  return "No reason was recorded.";
}

}  // namespace

std::string ranking_table_html(const ReportContent& content) {
  Range ranges[4];
  for (int k = 0; k < 4; ++k) ranges[k] = angle_range(content, angle_names[k]);
  const double full = largest_load(content.study.ranking);
  std::string html = "<table class=\"ranking sortable\">\n" + table_head(content) + "<tbody>\n";
  for (std::size_t i = 0; i < content.designs.size(); ++i)
    if (content.row(i).rank > 0) html += table_row(content, i, ranges, full);
  return html + "</tbody></table>\n";
}

std::string unranked_html(const ReportContent& content) {
  std::string rows;
  for (std::size_t i = 0; i < content.designs.size(); ++i) {
    const Evaluation& e = content.row(i).evaluation;
    if (content.row(i).rank > 0) continue;
    rows += "<tr id=\"" + content.designs[i].id + "\"><th scope=\"row\">" + html_escaped(e.name) +
            "</th><td>" + status_label(e.status) + "</td>";
    for (const char* angle : angle_names)
      rows += "<td class=\"num\">" + fixed(measured_or_requested(e.result, angle), 1) + "</td>";
    rows += "<td class=\"reason\">" + reason_of(e) + "</td></tr>\n";
  }
  if (rows.empty()) return rows;
  return "<table class=\"unranked\">\n<thead><tr><th scope=\"col\">Design</th><th scope=\"col\">Status</th>"
         "<th scope=\"col\" class=\"num\">Stem<small>deg</small></th><th scope=\"col\" "
         "class=\"num\">Water\u00adline"
         "<small>deg</small></th><th scope=\"col\" class=\"num\">Buttock<small>deg</small></th><th "
         "scope=\"col\" "
         "class=\"num\">Flare<small>deg</small></th><th scope=\"col\">Reason</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table>\n";
}

}  // namespace icebow
