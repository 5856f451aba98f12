#include "reports/html/chart_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/json_fields.h"
#include "reports/content/all_runs.h"
#include "reports/content/comparison.h"
#include "reports/html/front_view.h"
#include "reports/tables/table_report.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/spec/document_keys.h"

namespace icebow {
namespace {

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// Four digits are more than a screen shows, and a third of the bytes.
Json rounded(const std::vector<double>& values, const char* format) {
  Json list = Json::array();
  for (const double value : values) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    list.push_back(std::strtod(text, nullptr));
  }
  return list;
}

// From and to of the part the mean is taken over, full scale.
Json steady_part(const Json& result, double lambda) {
  double from = number_at(result, result_key::steady_from);
  double to = number_at(result, result_key::steady_to);
  if (!std::isfinite(from)) from = number_at(result, result_key::model_steady_from) * lambda;
  if (!std::isfinite(to)) to = number_at(result, result_key::model_steady_to) * lambda;
  return std::isfinite(from) && std::isfinite(to) ? Json::array({from, to}) : Json(nullptr);
}

// Where the margins that a hull must keep leave the least room: {"name", "value"}.
Json smallest_margin(const Json& result) {
  const Json& margins = part_at(result, result_key::margins);
  const Json& reported = part_at(result, result_key::margins_only_reported);
  const auto must_hold = [&](const std::string& name) {
    return !reported.is_array() || std::find(reported.begin(), reported.end(), Json(name)) == reported.end();
  };
  Json smallest;
  if (!margins.is_object()) return smallest;
  for (const auto& [name, value] : margins.items())
    if (value.is_number() && must_hold(name) && (smallest.is_null() || value < smallest["value"]))
      smallest = {{"name", name}, {"value", value}};
  return smallest;
}

// Of the record that is drawn: that of the first scenario, and of the cycle where simulations correct it.
double mean_of_record(const RankedDesign& row) {
  const std::vector<ScenarioLoad> scenarios = scenario_loads(row.evaluation.result);
  if (!scenarios.empty()) return scenarios.front().mean;
  return std::isfinite(row.difference_ci95) ? row.cycle_load : row.mean_load;
}

Json histories_json(const DesignContent& design) {
  Json list = Json::array();
  for (const LoadSeries& series : design.histories)
    list.push_back({{"advance_m", rounded(series.advance, "%.2f")},
                    {"load_N", rounded(series.load, "%.4g")},
                    {"samples", series.samples}});
  return list;
}

// Half of the waterline for the comparison of two bows, at most 40 points.
Json outline_json(const std::vector<Vec3>& waterline) {
  Json points = Json::array();
  const std::size_t step = std::max<std::size_t>(1, waterline.size() / 40);
  for (std::size_t i = 0; i < waterline.size(); i += step)
    points.push_back(
        {std::round(100.0 * waterline[i][0]) / 100.0, std::round(100.0 * waterline[i][1]) / 100.0});
  return points;
}

Json design_json(const ReportContent& content, std::size_t i) {
  const RankedDesign& row = content.row(i);
  const DesignContent& design = content.designs[i];
  const Evaluation& e = row.evaluation;
  Json angles;
  for (const char* angle : {"stem", "waterline", "buttock", "flare"})
    angles[angle] = number(measured_or_requested(e.result, angle));
  Json parameters = Json::object();
  for (const auto& [name, value] : e.parameters) parameters[name] = number(value);
  const std::string& by = content.study.ranking.rank_by;
  const MeanEstimate estimate = row.rank > 0 ? value_estimate(row, by) : MeanEstimate();
  const auto order = content.study.order.find(e.name);
  const bool tied = row.rank > 1 && compared_with(row, content.row(0), by).p >= told_apart_below;
  return {{"id", design.id},
          {"name", e.name},
          {"status", to_string(e.status)},
          {"order", order == content.study.order.end() ? 0 : order->second},
          {"rank", row.rank},
          {"tied_with_best", tied},
          {"value", number(row.value)},
          {"value_ci95", number(value_ci95(row, by))},
          {"second", number(row.second)},
          {"second_ci95", number(row.second_ci95)},
          {"front", to_string(row.front)},
          {"value_error", number(estimate.standard_error)},
          {"value_freedom", number(estimate.degrees_of_freedom)},
          {"mean_N", number(row.mean_load)},
          {"record_mean_N", number(mean_of_record(row))},
          {"ci95_N", number(row.mean_load_ci95)},
          {"max_N", number(over_runs(content.study, e, result_key::max_load, OverRuns::highest))},
          {"q95_N", number(over_runs(content.study, e, result_key::q95_load, OverRuns::mean))},
          {"lindqvist_N", number(row.lindqvist)},
          {"lambda", number(design.lambda)},
          {"angles_deg", angles},
          {"parameters", parameters},
          {"smallest_margin", smallest_margin(e.result)},
          {"steady_m", steady_part(e.result, design.lambda)},
          {"outline_m", outline_json(design.waterline)},
          {"histories", histories_json(design)}};
}

Json fit_json(const ResponseFit& fit) {
  if (!fit.told()) return nullptr;
  Json effects = Json::array();
  for (const Effect& effect : fit.effects)
    effects.push_back({{"pointer", effect.pointer},
                       {"lower", effect.lower},
                       {"upper", effect.upper},
                       {"change", number(effect.change)},
                       {"ci95", number(effect.ci95)},
                       {"at", rounded(effect.at, "%.5g")},
                       {"value", rounded(effect.value, "%.5g")},
                       {"half_width", rounded(effect.half_width, "%.4g")},
                       {"moved", rounded(effect.moved, "%.5g")}});
  return {{"names", fit.names}, {"effects", effects}};
}

// Of an optimiser's or a sweep's variables, as the study file has them.
Json bounds_json(const StudyResults& study) {
  Json bounds = Json::object();
  const Json& variables = part_at(study.document, document_key::method_variables);
  if (!variables.is_object()) return bounds;
  for (const auto& [pointer, range] : variables.items())
    if (std::isfinite(number_at(range, document_key::variable_min)))
      bounds[pointer] = {number_at(range, document_key::variable_min),
                         number_at(range, document_key::variable_max)};
  return bounds;
}

}  // namespace

Json chart_data(const ReportContent& content, const ResponseFit& fit) {
  Json designs = Json::array();
  for (std::size_t i = 0; i < content.designs.size(); ++i) designs.push_back(design_json(content, i));
  const Ranking& ranking = content.study.ranking;
  return {
      {"name", content.study.name},
      {"unit",
       {{"name", content.unit.name}, {"newtons", content.unit.newtons}, {"decimals", content.unit.decimals}}},
      {"rank_by", ranking.rank_by},
      {"quantity", ranked_quantity(ranking.rank_by)},
      {"compared", compared_part(ranking)},
      {"spearman", number(ranking.spearman)},
      {"spearman_n", ranking.spearman_n},
      {"bounds", bounds_json(content.study)},
      {"designs", designs},
      {"second", second_json(content)},
      {"fit", fit_json(fit)},
      {"csv", ranking_csv(content.study)}};
}

}  // namespace icebow
