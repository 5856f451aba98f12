#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "base/units.h"
#include "reports/content/verdict.h"
#include "reports/html/html_sections.h"
#include "reports/text/text_format.h"
#include "study/evaluate/provenance.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

std::string term(const std::string& name, const std::string& value_html) {
  return value_html.empty() ? value_html : "<div><dt>" + name + "</dt><dd>" + value_html + "</dd></div>\n";
}

// "2026-11-22T15:43:32Z" reads "2026-11-22 15:43 UTC"; anything else stays.
std::string time_in_words(const std::string& iso) {
  if (iso.size() != 20 || iso[10] != 'T' || iso[19] != 'Z') return iso;
  return iso.substr(0, 10) + "\u00a0" + iso.substr(11, 5) + " UTC";
}

std::string design_counts(const StudyResults& study) {
  std::string text = std::to_string(study.evaluated()) + " evaluated: " + std::to_string(study.ok) + " ok";
  if (study.infeasible > 0) text += ", " + std::to_string(study.infeasible) + " infeasible";
  if (study.failed > 0) text += ", " + std::to_string(study.failed) + " failed";
  if (!study.running.empty()) text += "; " + std::to_string(study.running.size()) + " running";
  if (!study.waiting.empty()) text += "; " + std::to_string(study.waiting.size()) + " not started";
  return text;
}

struct Condition {
  const char* name;
  const char* pointer;
  const char* unit;
  int decimals;
  double factor;
};

const Condition conditions[] = {
    {"Ice thickness", result_key::thickness, "m", 2, 1.0},
    {"Ship speed", result_key::speed, "kn", 2, 1.0 / metres_per_second_per_knot},
    {"Flexural strength", result_key::flexural_strength, "kPa", 0, 1e-3},
    {"Elastic modulus", result_key::elastic_modulus, "GPa", 2, 1e-9},
    {"Hull friction", result_key::friction, "", 2, 1.0},
    {"Ship length", result_key::ship_length, "m", 1, 1.0},
    {"Beam", result_key::ship_beam, "m", 1, 1.0},
    {"Draught", result_key::draught, "m", 1, 1.0},
    {"Model scale", result_key::lambda, "", 0, 1.0},
};

// "1.00 m", or "0.80 to 1.20 m" where the designs differ.
std::string condition_value(const ReportContent& content, const Condition& c) {
  double lowest = INFINITY, highest = -INFINITY;
  for (const RankedDesign& row : content.study.ranking.rows) {
    const double value = number_at(row.evaluation.result, c.pointer) * c.factor;
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  if (lowest > highest) return {};
  const bool is_scale = c.name == std::string("Model scale");
  std::string text = (is_scale ? "1\u2009:\u2009" : "") + fixed(lowest, c.decimals);
  if (fixed(highest, c.decimals) != fixed(lowest, c.decimals)) text += " to " + fixed(highest, c.decimals);
  return *c.unit ? text + "\u00a0" + c.unit : text;
}

}  // namespace

std::string verdict_html(const StudyResults& study) {
  const Verdict words = verdict(study);
  std::string html = "<p class=\"headline\">" + html_escaped(words.headline) + "</p>\n";
  if (words.remarks.empty()) return html;
  html += "<p class=\"remarks\">";
  for (const std::string& remark : words.remarks) html += html_escaped(remark) + ' ';
  return html + "</p>\n";
}

std::string provenance_html(const StudyResults& study) {
  const std::string command = study.command.empty() ? "" : "<code>" + html_escaped(study.command) + "</code>";
  return "<dl class=\"facts\">\n" + term("Designs", design_counts(study)) +
         term("Study started", html_escaped(time_in_words(study.started))) +
         term("Report written", time_in_words(utc_now())) +
         term("Computing time, all designs", duration(study.wall_seconds)) +
         term("Host", html_escaped(study.host)) + term("Icebow", html_escaped(study.version)) +
         term("Seed", html_escaped(study.seed)) + term("Command", command) + "</dl>\n";
}

std::string conditions_html(const ReportContent& content) {
  std::string terms;
  for (const Condition& c : conditions) terms += term(c.name, condition_value(content, c));
  return terms.empty() ? terms : "<dl class=\"facts\">\n" + terms + "</dl>\n";
}

}  // namespace icebow
