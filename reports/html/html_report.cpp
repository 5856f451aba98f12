#include "reports/html/html_report.h"

#include <cmath>

#include "base/json.h"
#include "base/json_fields.h"
#include "reports/content/inline_svg.h"
#include "reports/html/card_view.h"
#include "reports/html/chart_data.h"
#include "reports/html/content_security.h"
#include "reports/html/front_view.h"
#include "reports/html/overview_view.h"
#include "reports/html/packed_text.h"
#include "reports/html/page_template.h"
#include "reports/html/ranking_view.h"
#include "reports/html/report_assets.h"
#include "reports/html/shown_designs.h"
#include "reports/html/table_view.h"
#include "reports/text/text_format.h"
#include "study/effects/response_fit.h"
#include "study/evaluate/scenario_result.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

std::string record_in_words(const ReportContent& content, bool model) {
  std::string words = "Ice resistance against the distance sailed since first touch, full scale";
  words += model ? "; model-scale load on the right." : ".";
  for (const RankedDesign& row : content.study.ranking.rows) {
    const std::vector<ScenarioLoad> scenarios = scenario_loads(row.evaluation.result);
    if (scenarios.empty()) continue;
    return words + " The records and their means are those of the first scenario, " + scenarios.front().name +
           "; the loads beside the names are over all.";
  }
  if (content.study.ranking.confirmed.designs > 0)
    words += " The records and their means are the breaking cycle's, before the correction by simulations.";
  return words;
}

constexpr int whole_cards = 25;  // further ones are filled when a reader opens them
constexpr int open_cards = 3;

struct Cards {
  std::string html;
  Json bodies = Json::object();  // by the design's id, of cards that are filled later
};

Cards cards_of(const ReportContent& content) {
  Cards cards;
  for (std::size_t i = 0; i < content.designs.size(); ++i) {
    const int rank = content.row(i).rank;
    if (rank < 1) continue;
    Json head = card_head_view(content, i);
    std::string body = rendered("card_body", card_body_view(content, i));
    head["open"] = rank <= open_cards;
    head["body"] = rank <= whole_cards ? body : "";
    if (rank > whole_cards) cards.bodies[content.designs[i].id] = std::move(body);
    cards.html += rendered("card", head);
  }
  return cards;
}

Json first_screen(const ReportContent& content) {
  const StudyResults& study = content.study;
  const Json best = content.verdict.ranks ? podium_view(content) : Json::array();
  return {{"kicker", kicker(study)},
          {"name", study.name},
          {"purpose", study.purpose},
          {"unfinished", !study.finished()},
          {"headline", content.verdict.headline},
          {"has_best", best.size() > 1},
          {"best", best},
          {"ice", content.conditions.ice},
          {"next", content.verdict.next},
          {"has_remarks", !content.verdict.remarks.empty()},
          {"remarks", content.verdict.remarks}};
}

bool is_optimised(const StudyResults& study) {
  return text_at(study.document, document_key::method_type) == "optimise";
}

std::string share_in_words(const Share& share) {
  return fixed(share.value, 2) + " (" + fixed(share.low, 2) + " to " + fixed(share.high, 2) + ")";
}

Json shares_view(const ResponseFit& fit) {
  Json rows = Json::array();
  for (const Effect& e : fit.effects)
    rows.push_back({{"parameter", e.pointer},
                    {"first", share_in_words(e.sobol.first)},
                    {"total", share_in_words(e.sobol.total)}});
  return fit.has_sobol ? rows : Json::array();
}

Json charts(const ReportContent& content, const ResponseFit& fit) {
  const StudyResults& study = content.study;
  bool parameters = false, model = false;
  for (const RankedDesign& row : study.ranking.rows)
    parameters = parameters || (row.rank > 0 && !row.evaluation.parameters.empty());
  for (const DesignContent& design : content.designs) model = model || design.lambda > 1.0;
  const bool simulated = content.has_simulated();
  const std::string percent = "\u00a0%";
  return {
      {"quantity", ranked_quantity(study.ranking.rank_by)},
      {"chart_quantity",
       capitalised(content.has_loads() ? "mean ice load" : ranked_quantity(study.ranking.rank_by))},
      {"has_loads", content.has_loads()},
      {"has_model_loads", model},
      {"has_lindqvist", content.has_lindqvist()},
      {"has_both", content.has_loads() && content.has_lindqvist() && study.ranked() > 0},
      {"has_histories", content.has_histories()},
      {"has_optimiser", is_optimised(study)},
      {"has_parameters", parameters && study.ranked() > 2},
      {"constant_angles", ""},
      {"simulated_word", simulated ? "Simulated" : "Breaking cycle"},
      {"simulated_lower", simulated ? "simulated" : "cycle's"},
      {"unlike_ice", content.conditions.unlike_ices.empty()
                         ? ""
                         : "The two are of unlike ices: " + content.conditions.unlike_ices + "."},
      {"record_words", record_in_words(content, model)},
      {"has_fit", fit.told()},
      {"no_fit", parameters && study.ranked() > 2 && !fit.told() ? fit.why : ""},
      {"fit_words", "a polynomial " + terms_in_words(fit.terms) + ", fitted to " +
                        std::to_string(fit.designs) + " designs."},
      {"has_sobol", fit.has_sobol},
      {"no_sobol", fit.told() && !fit.has_sobol ? fixed(100.0 * fit.explained, 0) + percent : ""},
      {"shares", shares_view(fit)},
      {"fit_error",
       "A design left out of the fit is missed by " + fixed(100.0 * fit.left_out_error, 1) + percent +
           " of the mean load (root mean square); the designs themselves scatter by " +
           fixed(100.0 * fit.spread, 1) + percent +
           (fit.noise > 0.0 ? ", and their records err by " + fixed(100.0 * fit.noise, 1) + percent : "") +
           "."}};
}

Json page_view(ReportContent& content) {
  const StudyResults& study = content.study;
  const int ranked = study.ranked();
  ResponseFit fit = fit_response(study.ranking, held_pointer(study.document));
  const auto all_unranked = study.ranking.rows.size() - static_cast<std::size_t>(ranked);
  const std::string left_out = leave_what_fits(content, fit);
  const Cards cards = cards_of(content);
  const Json unranked = unranked_view(content);
  Json page = {
      {"version", study.version},
      {"ranked", ranked > 0},
      {"can_compare", ranked > 1},
      {"left_out", left_out},
      {"has_unranked", !unranked.empty()},
      {"unranked", unranked},
      {"unranked_left_out", all_unranked > unranked.size()
                                ? std::to_string(all_unranked - unranked.size()) + " more are in ranking.csv."
                                : ""},
      {"cards", cards.html},
      {"card_bodies", packed(json_text(cards.bodies))},
      {"method", method_view(content)},
      {"has_shared", !content.conditions.shared.empty()},
      {"shared", facts_view(content.conditions.shared, false)},
      {"has_simulated", !content.conditions.simulated.empty()},
      {"simulated", facts_view(content.conditions.simulated, false)},
      {"provenance", provenance_view(study)},
      {"policy", content_security_policy(report_script())},
      {"data", json_for_script(chart_data(content, fit))},
      {"style", report_style() + drawings_style()},
      {"script", report_script()}};
  page.update(first_screen(content));
  page.update(charts(content, fit));
  page.update(front_view(content));
  page.update(ranking_view(content));
  return page;
}

}  // namespace

void write_html_report(const std::string& study_directory, const std::string& html_path) {
  ReportContent content = read_report_content(study_directory);
  write_text_file(html_path, rendered("page", page_view(content)));
}

}  // namespace icebow
