#include "reports/html/html_report.h"

#include "base/json.h"
#include "reports/html/chart_data.h"
#include "reports/html/content_security.h"
#include "reports/html/html_sections.h"
#include "reports/html/page_template.h"
#include "reports/html/report_assets.h"
#include "reports/text/text_format.h"

namespace icebow {
namespace {

// A value for {{#name}} blocks: present or not.
std::string flag(bool on) {
  return on ? "yes" : "";
}

std::map<std::string, std::string> page_values(const ReportContent& content) {
  const StudyResults& study = content.study;
  const int ranked = study.ranked();
  return {{"name", html_escaped(study.name)},
          {"purpose", html_escaped(study.purpose)},
          {"version", html_escaped(study.version)},
          {"quantity", html_escaped(ranked_quantity(study.ranking.rank_by))},
          {"unit", content.unit.name},
          {"unfinished", flag(!study.finished())},
          {"verdict", verdict_html(study)},
          {"provenance", provenance_html(study)},
          {"conditions", conditions_html(content)},
          {"ranking", ranked > 0 ? ranking_table_html(content) : ""},
          {"cards", design_cards_html(content)},
          {"unranked", unranked_html(content)},
          {"has_loads", flag(content.has_loads())},
          {"has_lindqvist", flag(content.has_lindqvist())},
          {"has_both", flag(content.has_loads() && content.has_lindqvist() && ranked > 0)},
          {"has_histories", flag(content.has_histories())},
          {"policy", content_security_policy(report_script())},
          {"data", json_for_script(chart_data(content))},
          {"style", report_style()},
          {"script", report_script()}};
}

}  // namespace

void write_html_report(const std::string& study_directory, const std::string& html_path) {
  const ReportContent content = read_report_content(study_directory);
  write_text_file(html_path, filled(report_page_template(), page_values(content)));
}

}  // namespace icebow
