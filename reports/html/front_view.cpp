#include "reports/html/front_view.h"

#include <cmath>

#include "reports/content/load_unit.h"
#include "reports/html/table_view.h"
#include "reports/text/text_format.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr std::size_t most_rows = 40;

std::string with_unit(double value, double half, const SecondQuantity& q) {
  const std::string error =
      std::isfinite(half) && half > 0.0 ? "\u00a0\u00b1\u00a0" + brief(half / q.size) : "";
  return brief(value / q.size) + error + (q.unit.empty() ? "" : "\u00a0" + q.unit);
}

}  // namespace

Json front_view(const ReportContent& content) {
  const Ranking& ranking = content.study.ranking;
  const std::vector<std::string> front = names_at(ranking, FrontPlace::front),
                                 open = names_at(ranking, FrontPlace::open);
  if (!ranking.objective.given() || front.empty()) return {{"has_front", false}};
  const SecondQuantity q = second_quantity(content.study.ranking, content.unit);
  Json rows = Json::array();
  for (std::size_t i = 0; i < content.designs.size() && rows.size() < most_rows; ++i) {
    const RankedDesign& row = content.row(i);
    if (row.front != FrontPlace::front) continue;
    const double half = value_ci95(row, ranking.rank_by);
    rows.push_back({{"id", content.designs[i].id},
                    {"name", row.evaluation.name},
                    {"outline", outline_view(bow_outline(content.designs[i].waterline, content.bow_length,
                                                         content.bow_scale))},
                    {"first", with_interval(row.value / content.unit.newtons, half / content.unit.newtons,
                                            content.unit.decimals) +
                                  "\u00a0" + content.unit.name},
                    {"second", with_unit(row.second, row.second_ci95, q)}});
  }
  return {{"has_front", true},
          {"front", rows},
          {"front_count", std::to_string(front.size())},
          {"first_words", capitalised(ranked_quantity(ranking.rank_by))},
          {"second_words", (ranking.objective.largest ? "largest " : "smallest ") + q.words},
          {"open_words", open.empty() ? "" : std::to_string(open.size())}};
}

Json second_json(const ReportContent& content) {
  const SecondObjective& second = content.study.ranking.objective;
  if (!second.given()) return nullptr;
  const SecondQuantity q = second_quantity(content.study.ranking, content.unit);
  return {{"words", q.words},
          {"unit", q.unit},
          {"size", q.size},
          {"best", second.largest ? "largest" : "smallest"}};
}

}  // namespace icebow
