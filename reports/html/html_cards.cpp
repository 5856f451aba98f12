#include <cmath>

#include "base/json_fields.h"
#include "base/units.h"
#include "reports/html/html_cycle.h"
#include "reports/html/html_process.h"
#include "reports/html/html_sections.h"
#include "reports/tables/table_report.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

std::string figure(const std::string& html, const std::string& caption, const char* css_class) {
  return "<figure class=\"" + std::string(css_class) + "\">" + html + "<figcaption>" + caption +
         "</figcaption></figure>\n";
}

std::string table(const std::string& caption, const std::vector<std::string>& columns,
                  const std::string& rows) {
  if (rows.empty()) return {};
  std::string html = "<table><caption>" + caption + "</caption><thead><tr><td></td>";
  for (const std::string& column : columns) html += "<th scope=\"col\" class=\"num\">" + column + "</th>";
  return html + "</tr></thead><tbody>" + rows + "</tbody></table>\n";
}

std::string row(const std::string& name, const std::vector<std::string>& values, const char* css_class = "") {
  std::string html = "<tr class=\"" + std::string(css_class) + "\"><th scope=\"row\">" + name + "</th>";
  for (const std::string& value : values) html += "<td class=\"num\">" + value + "</td>";
  return html + "</tr>";
}

std::string angles_table(const Json& result) {
  std::string rows;
  const std::pair<const char*, const char*> names[] = {
      {"stem", "Stem"}, {"waterline", "Waterline"}, {"buttock", "Buttock, B/4"}, {"flare", "Flare, B/4"}};
  for (const auto& [key, label] : names) {
    const double wanted = number_at(result, result_key::requested_deg(key));
    const double got = number_at(result, result_key::measured_deg(key));
    if (std::isfinite(wanted) || std::isfinite(got)) rows += row(label, {fixed(wanted, 2), fixed(got, 2)});
  }
  const std::pair<const char*, const char*> derived[] = {{"waterline_at_quarter_beam", "Waterline, B/4"},
                                                         {"flare_at_stem", "Flare at stem"}};
  for (const auto& [key, label] : derived) {
    const double value = number_at(result, result_key::derived_deg(key));
    if (std::isfinite(value)) rows += row(label, {"follows", fixed(value, 2)}, "derived");
  }
  return table("Angles, deg", {"requested", "measured"}, rows);
}

// Where a hull that was not generated comes from, and what was mended in its mesh.
std::string imported_note(const Json& result) {
  const Json& imported = part_at(result, result_key::imported);
  if (!imported.is_object()) return {};
  std::string html = "<p class=\"note\">Hull imported from " + html_escaped(text_at(imported, "/file"));
  const Json& repairs = part_at(imported, "/repairs");
  if (repairs.is_array())
    for (const Json& words : repairs) html += "; " + html_escaped(text_at(words, ""));
  return html + ".</p>\n";
}

// The mean of repeated runs, with its interval by their scatter and by their own series.
std::string repeats_rows(const RankedDesign& ranked, const LoadUnit& unit) {
  if (ranked.runs < 2) return {};
  const auto full = [&](double half) {
    return with_interval(ranked.mean_load / unit.newtons, half / unit.newtons, unit.decimals);
  };
  return row("Mean of " + std::to_string(ranked.runs) + " runs, by their scatter",
             {full(ranked.ci95_repeats), ""}) +
         row("The same, by their series", {full(ranked.ci95_series), ""});
}

std::string loads_table(const Json& result, const RankedDesign& ranked, const LoadUnit& unit) {
  if (!std::isfinite(number_at(result, result_key::model_mean_load))) return {};
  std::string rows;
  const auto add = [&](const char* name, const result_key::Load& load) {
    const auto at = [&](const char* key) { return *key ? number_at(result, key) : std::nan(""); };
    const double full = at(load.full) / unit.newtons, model = at(load.model);
    if (!std::isfinite(full) && !std::isfinite(model)) return;
    rows += row(name, {with_interval(full, at(load.full_ci95) / unit.newtons, unit.decimals),
                       with_interval(model, at(load.model_ci95), 1)});
  };
  namespace key = result_key;
  add("Mean \u00b1 95\u00a0%",
      {key::mean_load, key::model_mean_load, key::mean_load_ci95, key::model_mean_load_ci95});
  add("Peak", {key::max_load, key::model_max_load});
  add("95\u00a0% quantile", {key::q95_load, key::model_q95_load});
  add("Standard deviation", {key::std_load, key::model_std_load});
  add("Vertical, mean",
      {key::vertical_mean, key::model_vertical_mean, key::vertical_mean_ci95, key::model_vertical_mean_ci95});
  rows += repeats_rows(ranked, unit);
  const std::string bias = text_at(result, result_key::bias_sentence);
  const std::string note = bias.empty() ? "" : "<p class=\"note\">" + html_escaped(bias) + ".</p>\n";
  return "<div>" + table("Simulated ice load", {"full scale, " + unit.name, "model, N"}, rows) + note +
         "</div>";
}

std::string lindqvist_table(const Json& result, const RankedDesign& ranked, const LoadUnit& unit) {
  const Json& part = part_at(result, result_key::lindqvist);
  if (part.is_null()) return {};
  if (is_false_at(result, result_key::lindqvist_valid))
    return "<p class=\"note\">Lindqvist's formula does not apply: " +
           html_escaped(text_at(result, result_key::lindqvist_reason)) + "</p>\n";
  const auto load = [&](double newtons) { return fixed(newtons / unit.newtons, unit.decimals); };
  const double crushing = number_at(result, result_key::lindqvist_crushing),
               bending = number_at(result, result_key::lindqvist_bending);
  const double breaking = number_at(result, result_key::lindqvist_breaking);
  std::string rows = row("Crushing", {load(crushing)}) + row("Bending", {load(bending)});
  rows += row("Speed factor", {fixed(breaking / (crushing + bending), 3)});
  rows += row("Breaking", {load(breaking)}, "sum") +
          row("Submersion", {load(number_at(result, result_key::lindqvist_submersion))});
  rows += row("Total resistance", {load(number_at(result, result_key::lindqvist_total))}, "sum");
  rows += row(std::string("Simulated mean / ") + (ranked.whole_load ? "total" : "breaking"),
              {fixed(ranked.ratio, 2)});
  const std::string caution = text_at(result, result_key::lindqvist_caution);
  return "<div>" + table("Lindqvist's formula", {unit.name}, rows) +
         (caution.empty() ? "" : "<p class=\"note\">" + html_escaped(caution) + "</p>\n") + "</div>";
}

std::string margins_list(const Json& result) {
  const Json& margins = part_at(result, result_key::margins);
  if (!margins.is_object() || margins.empty()) return {};
  std::string html =
      "<h4>Feasibility margins <small>satisfied where not negative</small></h4><ul class=\"margins\">";
  for (const auto& [name, value] : margins.items()) {
    const double margin = value.is_number() ? value.get<double>() : std::nan("");
    const std::string sentence = text_at(part_at(result, result_key::margin_sentences), "/" + name);
    html += std::string("<li class=\"") + (margin < 0.0 ? "negative" : "positive") + "\"><b>" +
            html_escaped(name) + "</b> <span class=\"num\">" + fixed(margin, 2) + "</span> <span>" +
            html_escaped(sentence) + "</span></li>";
  }
  return html + "</ul>\n";
}

// "key figure: value" pairs in small print.
class Facts {
 public:
  void add(const std::string& name, const std::string& value) {
    html_ += "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>";
  }
  void add(const std::string& name, double value, int decimals, const std::string& unit = "") {
    if (std::isfinite(value)) add(name, fixed(value, decimals) + (unit.empty() ? "" : "\u00a0" + unit));
  }
  void count(const std::string& name, double value) {
    if (std::isfinite(value)) add(name, with_thousands(std::llround(value)));
  }
  std::string list() const {
    return html_.empty() ? html_ : "<dl class=\"facts small\">" + html_ + "</dl>\n";
  }

 private:
  std::string html_;
};

std::string ice_facts(const Json& result, double lambda) {
  Facts facts;
  const double cubic_metres = std::pow(lambda, 3);
  facts.add("Steady part, full scale",
            fixed(number_at(result, result_key::model_steady_from) * lambda, 1) + " to " +
                fixed(number_at(result, result_key::model_steady_to) * lambda, 1) + "\u00a0m of advance");
  facts.add("Independent samples in it", number_at(result, result_key::effective_samples), 0);
  facts.add("Channel width / beam", number_at(result, result_key::channel_width_over_beam), 2);
  facts.count("Floes", number_at(result, result_key::pieces));
  facts.add("Broken ice, full scale", number_at(result, result_key::broken_volume) * cubic_metres, 0,
            "m\u00b3");
  facts.add("Crushed ice, full scale", number_at(result, result_key::crushed_volume) * cubic_metres, 0,
            "m\u00b3");
  facts.count("Broken bonds", number_at(result, result_key::broken_bonds));
  return std::isfinite(number_at(result, result_key::model_mean_load)) ? "<h4>Ice</h4>" + facts.list()
                                                                       : std::string();
}

std::string simulation_facts(const Json& result, double wall_seconds) {
  const Json& run = part_at(result, result_key::simulation);
  if (!run.is_object()) return {};
  Facts facts;
  const double nx = number_at(result, result_key::particles_along),
               ny = number_at(result, result_key::particles_across),
               nz = number_at(result, result_key::layers);
  if (std::isfinite(nx * ny * nz))
    facts.add("Particles",
              fixed(nx, 0) + "\u2009\u00d7\u2009" + fixed(ny, 0) + "\u2009\u00d7\u2009" + fixed(nz, 0));
  facts.count("Steps", number_at(result, result_key::steps));
  facts.add("Time step, model", number_at(result, result_key::time_step) * 1e6, 1, "\u00b5s");
  const double stretch = number_at(result, result_key::critical_stretch);
  if (std::isfinite(stretch)) facts.add("Critical stretch", engineering(stretch, ""));
  const double tensile = number_at(result, result_key::tensile_strength),
               crushing = number_at(result, result_key::crushing_pressure);
  if (std::isfinite(tensile)) facts.add("Tensile strength of bonds, model", tensile / 1e3, 1, "kPa");
  if (std::isfinite(crushing)) facts.add("Crushing pressure, model", crushing / 1e3, 1, "kPa");
  const double flexural = number_at(result, result_key::simulated_flexural_strength);
  if (std::isfinite(flexural))
    facts.add("Flexural strength of the simulated ice, full scale", flexural / 1e3, 0, "kPa");
  facts.add("Model scale", "1\u2009:\u2009" + fixed(number_at(result, result_key::lambda), 0));
  facts.add("Wall time", duration(wall_seconds));
  const double ranks = number_at(result, result_key::ranks);
  if (std::isfinite(ranks)) facts.count("Ranks", ranks);
  facts.add("Time per bond and step", number_at(result, result_key::ns_per_bond), 2, "ns");
  return "<h4>Simulation</h4>" + facts.list();
}

std::string picture_strip(const DesignContent& design, const std::string& name) {
  if (design.pictures.empty()) return {};
  std::string figures;
  for (const Picture& picture : design.pictures) {
    std::string advance = "advance unknown";
    if (std::isfinite(picture.advance))
      advance = std::isfinite(design.lambda)
                    ? fixed(picture.advance * design.lambda, 1) + "\u00a0m <small>(model " +
                          fixed(picture.advance, 2) + "\u00a0m)</small>"
                    : fixed(picture.advance, 2) + "\u00a0m <small>model</small>";
    figures +=
        figure("<button type=\"button\" class=\"zoom\"><img loading=\"lazy\" alt=\"Broken ice around " +
                   html_escaped(name) + " seen from above\" src=\"data:image/png;base64," +
                   base64(read_text_file(picture.path)) + "\"></button>",
               advance, "picture");
  }
  std::string html =
      "<h4>Ice from above <small>advance since first touch, full scale</small></h4><div class=\"strip\">" +
      figures + "</div>\n";
  if (design.pictures_left_out > 0)
    html += "<p class=\"note\">" + std::to_string(design.pictures_left_out) +
            " more in the design's directory; left out to keep this file small.</p>\n";
  return html;
}

std::string card_summary(const ReportContent& content, const RankedDesign& ranked) {
  const LoadUnit& unit = content.unit;
  std::string html = "<summary><span class=\"rank\">" + std::to_string(ranked.rank) + "</span><h3>" +
                     html_escaped(ranked.evaluation.name) + "</h3>";
  if (std::isfinite(ranked.mean_load))
    html +=
        "<span class=\"load\">" +
        with_interval(ranked.mean_load / unit.newtons, ranked.mean_load_ci95 / unit.newtons, unit.decimals) +
        "\u00a0" + unit.name + "</span>";
  if (ranked.tied_with_best && ranked.rank > 1) html += "<span class=\"chip\">\u2248 best</span>";
  return html + "</summary>\n";
}

std::string card(const ReportContent& content, std::size_t i) {
  const RankedDesign& ranked = content.row(i);
  const DesignContent& design = content.designs[i];
  const Json& result = ranked.evaluation.result;
  std::string html = "<details class=\"card\" id=\"" + design.id + "\"" + (ranked.rank <= 3 ? " open" : "") +
                     ">\n" + card_summary(content, ranked);
  html += "<div class=\"card-body\">\n";
  html += design.lines_plan.empty()
              ? "<p class=\"note\">No lines plan was written for this design.</p>\n"
              : figure("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Lines plan\">" +
                           design.lines_plan + "</div>",
                       "Lines plan, full scale.", "lines");
  html += imported_note(result) + "<div class=\"tables\">" + angles_table(result) +
          loads_table(result, ranked, content.unit) + lindqvist_table(result, ranked, content.unit) +
          "</div>\n";
  html += cycle_html(ranked, design, content.unit);
  html += process_html(result, design.lambda) + picture_strip(design, ranked.evaluation.name);
  html += "<div class=\"small-print\"><div>" + margins_list(result) + "</div><div>" +
          ice_facts(result, design.lambda) + "</div><div>" +
          simulation_facts(result, ranked.evaluation.wall_seconds) + "</div></div>\n";
  return html + "</div></details>\n";
}

}  // namespace

std::string design_cards_html(const ReportContent& content) {
  std::string html;
  for (std::size_t i = 0; i < content.designs.size(); ++i)
    if (content.row(i).rank > 0) html += card(content, i);
  return html;
}

}  // namespace icebow
