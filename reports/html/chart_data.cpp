#include "reports/html/chart_data.h"

#include <cmath>
#include <cstdlib>

#include "base/json_fields.h"
#include "base/text.h"
#include "reports/tables/table_report.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

// Four digits are more than a screen shows, and a third of the bytes.
Json rounded(const std::vector<double>& values, const char* format) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::strtod(text(format, value).c_str(), nullptr));
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

Json design_json(const RankedDesign& row, const DesignContent& design) {
  const Evaluation& e = row.evaluation;
  Json angles;
  for (const char* angle : {"stem", "waterline", "buttock", "flare"})
    angles[angle] = finite_or_null(measured_or_requested(e.result, angle));
  Json parameters = Json::object();
  for (const auto& [name, value] : e.parameters) parameters[name] = finite_or_null(value);
  Json json = {{"id", design.id},
               {"name", e.name},
               {"status", to_string(e.status)},
               {"rank", row.rank},
               {"tied_with_best", row.tied_with_best},
               {"tied_with_next", row.tied_with_next},
               {"mean_N", finite_or_null(row.mean_load)},
               {"ci95_N", finite_or_null(row.mean_load_ci95)},
               {"max_N", finite_or_null(number_at(e.result, result_key::max_load))},
               {"q95_N", finite_or_null(number_at(e.result, result_key::q95_load))},
               {"lindqvist_N", finite_or_null(row.lindqvist)},
               {"lambda", finite_or_null(design.lambda)},
               {"angles_deg", angles},
               {"parameters", parameters},
               {"steady_m", steady_part(e.result, design.lambda)},
               {"history", nullptr}};
  if (!design.history.load.empty())
    json["history"] = {{"advance_m", rounded(design.history.advance, "%.2f")},
                       {"load_N", rounded(design.history.load, "%.4g")},
                       {"samples", design.history.samples}};
  return json;
}

}  // namespace

Json chart_data(const ReportContent& content) {
  Json designs = Json::array();
  for (std::size_t i = 0; i < content.designs.size(); ++i)
    designs.push_back(design_json(content.row(i), content.designs[i]));
  return {
      {"name", content.study.name},
      {"unit",
       {{"name", content.unit.name}, {"newtons", content.unit.newtons}, {"decimals", content.unit.decimals}}},
      {"rank_by", content.study.ranking.rank_by},
      {"spearman", finite_or_null(content.study.ranking.spearman)},
      {"spearman_n", content.study.ranking.spearman_n},
      {"designs", designs},
      {"csv", ranking_csv(content.study)}};
}

}  // namespace icebow
