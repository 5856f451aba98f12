// A stored result, whose JSON anybody may have written: it is ranked, and its report and tables are written.
#include "base/errors.h"
#include "reports/html/card_view.h"
#include "reports/html/chart_data.h"
#include "reports/html/overview_view.h"
#include "reports/html/page_template.h"
#include "reports/html/ranking_view.h"
#include "reports/tables/table_report.h"
#include "study/effects/response_fit.h"
#include "study/look/study_table.h"
#include "study/plan/ranking.h"

using namespace icebow;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Evaluation e;
  e.name = "baseline";
  e.status = EvaluationStatus::ok;
  try {
    e.result = parse_json(std::string(reinterpret_cast<const char*>(data), size), "result");
  } catch (const InputError&) {
    return 0;
  }
  ReportContent content;
  content.study.ranking = rank_designs({e, e}, size % 2 == 0 ? "mean_load" : "lindqvist_breaking");
  content.designs.assign(content.study.ranking.rows.size(), DesignContent());
  content.unit = load_unit(content.study.ranking);
  to_json(content.study.ranking);
  ranking_csv(content.study);
  ranking_markdown(content.study);
  study_csv(Json::array({{{"design", e.name},
                          {"status", "ok"},
                          {"reason", ""},
                          {"rank", 1},
                          {"parameters", Json::object()},
                          {"result", e.result.is_object() ? e.result : Json::object()}}}));
  json_text(ranking_view(content));
  json_text(unranked_view(content));
  json_text(podium_view(content));
  json_text(method_view(content));
  for (std::size_t i = 0; i < content.designs.size(); ++i) {
    Json card = card_head_view(content, i);
    card["open"] = true, card["body"] = rendered("card_body", card_body_view(content, i));
    rendered("card", card);
  }
  json_text(chart_data(content, fit_response(content.study.ranking)));
  return 0;
}
