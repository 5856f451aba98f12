// A stored result, whose JSON anybody may have written: it is ranked and its report drawn.
#include "base/errors.h"
#include "reports/html/chart_data.h"
#include "reports/html/html_sections.h"
#include "reports/tables/table_report.h"
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
  for (const char* by : {"mean_load", "lindqvist_breaking"}) {
    content.study.ranking = rank_designs({e, e}, by);
    content.designs.assign(content.study.ranking.rows.size(), DesignContent());
    content.unit = load_unit(content.study.ranking);
    to_json(content.study.ranking);
    ranking_table_html(content);
    design_cards_html(content);
    unranked_html(content);
    chart_data(content);
  }
  return 0;
}
