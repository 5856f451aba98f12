#include "reports/html/ranking_view.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "reports/content/all_runs.h"
#include "reports/content/comparison.h"
#include "reports/content/load_unit.h"
#include "reports/html/table_view.h"
#include "reports/tables/table_report.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

const char* const angle_names[] = {"stem", "waterline", "buttock", "flare"};
constexpr std::size_t most_unranked = 200;
constexpr std::size_t most_rows = 32,
                      first_rows = 25;  // of a longer table the first rows alone are shown at first

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

std::string percent(double value, double full) {
  return csv_number(std::round(std::clamp(1000.0 * value / full, 0.0, 1000.0)) / 10.0) + "%";
}

// A cell that sorts by its number; unknown numbers sort last.
Json cell(double sort_value, const std::string& text, const char* kind = "num") {
  return {{"sort", csv_number(sort_value)},
          {"text", text},
          {"kind", kind},
          {"mark", nullptr},
          {"place", nullptr},
          {"small", nullptr}};
}

// The angle, and where it lies between the lowest and the highest of the study.
Json angle_cell(double value, const Range& range) {
  Json json = cell(value, fixed(value, 1), "num angle");
  if (range.upper - range.lower > 0.5 && std::isfinite(value))
    json["place"] = fixed(100.0 * (value - range.lower) / (range.upper - range.lower), 0);
  return json;
}

// What a study's own number ranks is the bar; else the mean load, or Lindqvist's value where there is none.
double bar_length(const RankedDesign& row, const std::string& by) {
  if (is_own_number(by)) return row.value;
  return std::isfinite(row.mean_load) ? row.mean_load : row.lindqvist;
}

Json whisker(double mean, double half, double full) {
  if (!std::isfinite(half)) return nullptr;
  return {{"from", percent(mean - half, full)}, {"to", percent(mean + half, full)}};
}

// Whiskers over the mean's interval, a diamond at Lindqvist's value. `full` newtons fill the width.
Json load_bar(const RankedDesign& row, const std::string& by, double full) {
  const double length = bar_length(row, by);
  if (!std::isfinite(length) || full <= 0.0) return nullptr;
  return {{"width", percent(length, full)},
          {"whisker", whisker(length, length == row.mean_load ? row.mean_load_ci95 : NAN, full)},
          {"lindqvist",
           std::isfinite(row.lindqvist) && std::isfinite(row.mean_load) ? percent(row.lindqvist, full) : ""}};
}

double largest_load(const Ranking& ranking) {
  double largest = 0.0;
  for (const RankedDesign& row : ranking.rows)
    for (const double load : {row.mean_load + (std::isfinite(row.mean_load_ci95) ? row.mean_load_ci95 : 0.0),
                              row.lindqvist, bar_length(row, ranking.rank_by)})
      if (row.rank > 0 && std::isfinite(load)) largest = std::max(largest, load);
  return 1.05 * largest;
}

Json mean_cell(const ReportContent& content, const RankedDesign& row, double lambda) {
  const LoadUnit& unit = content.unit;
  Json json =
      cell(row.mean_load,
           with_interval(row.mean_load / unit.newtons, row.mean_load_ci95 / unit.newtons, unit.decimals),
           "num strong");
  // The breaking cycle sails at full scale: it has no model's load.
  if (lambda > 1.0) {
    const double to_model = 1.0 / std::pow(lambda, 3);
    json["small"] = with_interval(row.mean_load * to_model, row.mean_load_ci95 * to_model, 1) + " N";
  }
  return json;
}

Json ratio_cell(const RankedDesign& row) {
  Json json = cell(row.ratio, fixed(row.ratio, 2));
  const std::string unlike = unlike_ice_words(row.evaluation.result);
  if (!unlike.empty() && std::isfinite(row.ratio)) json["mark"] = "unlike ices: " + unlike;
  return json;
}

Json lindqvist_cell(const RankedDesign& row, const LoadUnit& unit) {
  Json json = cell(row.lindqvist, fixed(row.lindqvist / unit.newtons, unit.decimals));
  const std::string caution = text_at(row.evaluation.result, result_key::lindqvist_caution);
  if (!caution.empty()) json["mark"] = caution;
  return json;
}

Json cells_of(const ReportContent& content, std::size_t i, const Range ranges[4]) {
  const RankedDesign& row = content.row(i);
  const LoadUnit& unit = content.unit;
  Json cells = Json::array();
  for (int k = 0; k < 4; ++k)
    cells.push_back(angle_cell(measured_or_requested(row.evaluation.result, angle_names[k]), ranges[k]));
  if (is_own_number(content.study.ranking.rank_by))
    cells.push_back(cell(row.value, load_number(row.value / unit.newtons, unit), "num strong"));
  if (content.has_loads()) {
    cells.push_back(mean_cell(content, row, content.designs[i].lambda));
    const double peak = over_runs(content.study, row.evaluation, result_key::max_load, OverRuns::highest);
    cells.push_back(cell(peak, fixed(peak / unit.newtons, unit.decimals)));
  }
  if (content.has_lindqvist()) cells.push_back(lindqvist_cell(row, unit));
  if (content.has_loads() && content.has_lindqvist()) cells.push_back(ratio_cell(row));
  return cells;
}

struct AgainstBest {
  double p;
  bool tied;
  std::string words;
};

// By the race where the study decides, which has looked at the records several times; else by one test.
AgainstBest against_best(const ReportContent& content, std::size_t i) {
  const RankedDesign& row = content.row(i);
  const Ranking& ranking = content.study.ranking;
  const std::string place = place_in_race(ranking.race, row.evaluation.name);
  const double p = row.rank <= 1 ? NAN : compared_with(row, content.row(0), ranking.rank_by).p;
  if (!place.empty()) {
    const bool open = is_in(ranking.race.legs.back(), row.evaluation.name);
    return {p, open && row.rank > 1, place};
  }
  const bool tied = p >= told_apart_below;
  return {p, tied, std::isnan(p) ? "" : p_in_words(p) + (tied ? " \u2248" : "")};
}

Json row_of(const ReportContent& content, std::size_t i, const Range ranges[4], double full) {
  const RankedDesign& row = content.row(i);
  const AgainstBest against = against_best(content, i);
  const BowOutline outline = bow_outline(content.designs[i].waterline, content.bow_length, content.bow_scale);
  return {{"id", content.designs[i].id},
          {"rank", std::to_string(row.rank)},
          {"name", row.evaluation.name},
          {"kind", row.rank == 1  ? "best"
                   : against.tied ? "tied"
                                  : ""},
          {"outline", outline_view(outline)},
          {"cells", cells_of(content, i, ranges)},
          {"bar", load_bar(row, content.study.ranking.rank_by, full)},
          {"p", csv_number(against.p)},
          {"ties", against.words}};
}

Json column(const std::string& label, const std::string& unit, const char* kind = "num", bool sorts = true) {
  return {{"label", label}, {"unit", unit}, {"kind", kind}, {"sorts", sorts}};
}

Json columns_of(const ReportContent& content) {
  const std::string& unit = content.unit.name;
  const double full = largest_load(content.study.ranking) / content.unit.newtons;
  Json columns = {column("Rank", ""), column("Design", "", "text")};
  for (const char* label : {"Stem", "Water\u00adline", "Buttock", "Flare"})
    columns.push_back(column(label, "deg", "num angle"));
  if (is_own_number(content.study.ranking.rank_by))
    columns.push_back(column(capitalised(ranked_quantity(content.study.ranking.rank_by)), unit));
  if (content.has_loads()) {
    bool model = false;
    for (const DesignContent& design : content.designs) model = model || design.lambda > 1.0;
    columns.push_back(column("Mean load \u00b1 95\u00a0%", unit + (model ? ", model N" : "")));
    columns.push_back(column("Peak", unit));
  }
  if (content.has_lindqvist())
    columns.push_back(column("Lindqvist", compared_part(content.study.ranking) + ", " + unit));
  if (content.has_loads() && content.has_lindqvist()) columns.push_back(column("Ratio", "mean / L."));
  columns.push_back(column("0 to " + fixed(full, 2) + "\u00a0" + unit, "", "scale", false));
  if (content.study.ranking.race.given())
    columns.push_back(column("Race", ""));
  else if (content.has_loads())
    columns.push_back(column("As 1?", "p of equal means"));
  return columns;
}

std::string status_label(EvaluationStatus status) {
  switch (status) {
    case EvaluationStatus::infeasible:
      return "\u25b3 infeasible";
    case EvaluationStatus::failed:
      return "\u2715 failed";
    case EvaluationStatus::damaged:
      return "\u2715 damaged";
    case EvaluationStatus::running:
      return "\u2026 running";
    case EvaluationStatus::ok:
      break;
  }
  return "not ranked";
}

std::string reason_of(const Evaluation& e) {
  if (!e.reason.empty()) return e.reason;
  if (e.status == EvaluationStatus::running) return "Started; no result yet.";
  if (e.status == EvaluationStatus::ok) return "The result holds no value to rank by.";
  return "No reason was recorded.";
}

bool has_measured_angles(const ReportContent& content) {
  return std::any_of(
      content.study.ranking.rows.begin(), content.study.ranking.rows.end(), [](const RankedDesign& row) {
        return std::isfinite(number_at(row.evaluation.result, result_key::measured_deg("stem")));
      });
}

bool has_mark(const Json& row) {
  return std::any_of(row["cells"].begin(), row["cells"].end(),
                     [](const Json& c) { return !c["mark"].is_null(); });
}

}  // namespace

Json ranking_view(const ReportContent& content) {
  Range ranges[4];
  for (int k = 0; k < 4; ++k) ranges[k] = angle_range(content, angle_names[k]);
  const double full = largest_load(content.study.ranking);
  Json rows = Json::array();
  for (std::size_t i = 0; i < content.designs.size(); ++i)
    if (content.row(i).rank > 0) rows.push_back(row_of(content, i, ranges, full));
  const std::string part = compared_part(content.study.ranking);
  const bool marked = std::any_of(rows.begin(), rows.end(), has_mark);
  const std::size_t all = rows.size(), shown = all <= most_rows ? all : first_rows;
  Json more = Json::array();
  for (std::size_t i = shown; i < all; ++i) more.push_back(std::move(rows[i]));
  rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(shown), rows.end());
  return {{"columns", columns_of(content)},
          {"rows", rows},
          {"has_more", !more.empty()},
          {"more_rows", more},
          {"shown", shown},
          {"all", all},
          {"angles_from", has_measured_angles(content)
                              ? "Angles are measured on the hull mesh"
                              : "Angles are those asked for: the formula alone makes no hull"},
          {"has_ties", content.has_loads()},
          {"has_marks", marked},
          {"compared", part == "total" ? "total" : part + " part"}};
}

Json podium_view(const ReportContent& content) {
  const Ranking& ranking = content.study.ranking;
  double full = 0.0;
  for (std::size_t i = 0; i < content.designs.size() && content.row(i).rank > 0 && i < 3; ++i) {
    const double half = value_ci95(content.row(i), ranking.rank_by);
    full = std::max(full, 1.05 * (content.row(i).value + (std::isfinite(half) ? half : 0.0)));
  }
  Json best = Json::array();
  for (std::size_t i = 0; i < content.designs.size() && content.row(i).rank > 0 && i < 3; ++i) {
    const RankedDesign& row = content.row(i);
    std::vector<std::string> angles;
    for (const char* angle : angle_names)
      angles.push_back(fixed(measured_or_requested(row.evaluation.result, angle), 1) + "\u00b0");
    best.push_back({{"id", content.designs[i].id},
                    {"rank", std::to_string(row.rank)},
                    {"name", row.evaluation.name},
                    {"outline", outline_view(bow_outline(content.designs[i].waterline, content.bow_length,
                                                         2.0 * content.bow_scale))},
                    {"angles", "stem " + angles[0] + ", waterline " + angles[1] + ", buttock " + angles[2] +
                                   ", flare " + angles[3]},
                    {"bar", percent(row.value, full)},
                    {"whisker", whisker(row.value, value_ci95(row, ranking.rank_by), full)},
                    {"value", value_in_words(row, ranking)},
                    {"versus", versus_in_words(row, content.study)}});
  }
  return best;
}

Json unranked_view(const ReportContent& content) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < content.designs.size() && rows.size() < most_unranked; ++i) {
    const Evaluation& e = content.row(i).evaluation;
    if (content.row(i).rank > 0) continue;
    Json angles = Json::array();
    for (const char* angle : angle_names) angles.push_back(fixed(measured_or_requested(e.result, angle), 1));
    rows.push_back({{"id", content.designs[i].id},
                    {"name", e.name},
                    {"status", status_label(e.status)},
                    {"angles", angles},
                    {"reason", reason_of(e)}});
  }
  return rows;
}

}  // namespace icebow
