#include "reports/html/card_view.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "base/json_words.h"
#include "base/shell_word.h"
#include "base/units.h"
#include "reports/content/all_runs.h"
#include "reports/content/comparison.h"
#include "reports/html/process_view.h"
#include "reports/html/table_view.h"
#include "reports/tables/table_report.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"

namespace icebow {
namespace {

Json angles_table(const Json& result) {
  Json rows = Json::array();
  const std::pair<const char*, const char*> names[] = {
      {"stem", "Stem"}, {"waterline", "Waterline"}, {"buttock", "Buttock, B/4"}, {"flare", "Flare, B/4"}};
  for (const auto& [key, label] : names) {
    const double wanted = number_at(result, result_key::requested_deg(key));
    const double got = number_at(result, result_key::measured_deg(key));
    if (std::isfinite(wanted) || std::isfinite(got))
      rows.push_back(row_view(label, {fixed(wanted, 2), fixed(got, 2)}));
  }
  const std::pair<const char*, const char*> derived[] = {{"waterline_at_quarter_beam", "Waterline, B/4"},
                                                         {"flare_at_stem", "Flare at stem"}};
  for (const auto& [key, label] : derived) {
    const double value = number_at(result, result_key::derived_deg(key));
    if (std::isfinite(value)) rows.push_back(row_view(label, {"follows", fixed(value, 2)}, "derived"));
  }
  return table_view("Angles, deg", {"requested", "measured"}, rows);
}

// Where a hull that was not generated comes from, and what was mended in its mesh.
std::string imported_note(const Json& result) {
  if (!part_at(result, result_key::imported).is_object()) return {};
  std::string words = "Hull imported from " + text_at(result, result_key::imported_file);
  const Json& repairs = part_at(result, result_key::imported_repairs);
  if (repairs.is_array())
    for (const Json& repair : repairs) words += "; " + text_at(repair, "");
  return words + ".";
}

// Of repeated runs all numbers are of all of them: their mean, and their highest peak.
Json loads_table(const ReportContent& content, const RankedDesign& ranked, double lambda) {
  const Json& first = ranked.evaluation.result;
  const int runs = runs_of(content.study, ranked.evaluation);
  if (!std::isfinite(number_at(first, result_key::model_mean_load))) return nullptr;
  const LoadUnit& unit = content.unit;
  const double to_model = lambda > 1.0 ? 1.0 / std::pow(lambda, 3) : NAN;  // at full scale there is no model
  Json rows = Json::array();
  const auto add = [&](const std::string& name, double newtons, double half) {
    if (!std::isfinite(newtons)) return;
    std::vector<std::string> values = {
        with_interval(newtons / unit.newtons, half / unit.newtons, unit.decimals)};
    if (lambda > 1.0) values.push_back(with_interval(newtons * to_model, half * to_model, 1));
    rows.push_back(row_view(name, values));
  };
  const auto of = [&](const char* key, OverRuns how = OverRuns::mean) {
    return over_runs(content.study, ranked.evaluation, key, how);
  };
  if (runs > 1) {
    add("Mean of " + std::to_string(runs) + " runs, by their scatter", of(result_key::mean_load),
        ranked.ci95_repeats);
    add("The same, by their series", of(result_key::mean_load), ranked.ci95_series);
  } else {
    add("Mean \u00b1 95\u00a0%", of(result_key::mean_load), of(result_key::mean_load_ci95));
  }
  add("Peak", of(result_key::max_load, OverRuns::highest), NAN);
  add("95\u00a0% quantile", of(result_key::q95_load), NAN);
  add("Standard deviation", of(result_key::std_load), NAN);
  add("Vertical, mean", of(result_key::vertical_mean), runs > 1 ? NAN : of(result_key::vertical_mean_ci95));
  const std::string bias = text_at(first, result_key::bias_sentence);
  std::vector<std::string> columns = {"full scale, " + unit.name};
  if (lambda > 1.0) columns.push_back("model, N");
  const bool simulated = part_at(first, result_key::simulation).is_object();
  return table_view(simulated ? "Simulated ice load" : "Ice load by the breaking cycle", columns, rows,
                    bias.empty() ? std::vector<std::string>() : std::vector<std::string>{bias + "."});
}

Json lindqvist_table(const Json& result, const RankedDesign& ranked, const LoadUnit& unit) {
  if (part_at(result, result_key::lindqvist).is_null() || is_false_at(result, result_key::lindqvist_valid))
    return nullptr;
  const auto load = [&](double newtons) { return fixed(newtons / unit.newtons, unit.decimals); };
  const double crushing = number_at(result, result_key::lindqvist_crushing),
               bending = number_at(result, result_key::lindqvist_bending);
  const double breaking = number_at(result, result_key::lindqvist_breaking);
  Json rows = Json::array();
  rows.push_back(row_view("Crushing", {load(crushing)}));
  rows.push_back(row_view("Bending", {load(bending)}));
  rows.push_back(row_view("Speed factor", {fixed(breaking / (crushing + bending), 3)}));
  rows.push_back(row_view("Breaking", {load(breaking)}, "sum"));
  rows.push_back(row_view("Submersion", {load(number_at(result, result_key::lindqvist_submersion))}));
  rows.push_back(row_view("Total resistance", {load(number_at(result, result_key::lindqvist_total))}, "sum"));
  const bool simulated = part_at(result, result_key::simulation).is_object();
  const std::string unlike = unlike_ice_words(result);
  if (std::isfinite(ranked.ratio))
    rows.push_back(row_view(std::string(simulated ? "Simulated mean / " : "Mean of the cycle / ") +
                                (ranked.whole_load ? "total" : "breaking"),
                            {fixed(ranked.ratio, 2) + (unlike.empty() ? "" : "\u2009\u2020")}));
  return table_view("Lindqvist's formula", {unit.name}, rows);
}

// Of a study over scenarios, what the loads are made of.
Json scenarios_table(const Json& result, const LoadUnit& unit) {
  const Json& list = part_at(result, result_key::scenarios);
  if (!list.is_array()) return nullptr;
  Json rows = Json::array();
  for (const Json& one : list) {
    const auto load = [&](const char* key) {
      return fixed(number_at(one, key) / unit.newtons, unit.decimals);
    };
    const auto mean = [&](const char* key, const char* ci95) {
      return with_interval(number_at(one, key) / unit.newtons, number_at(one, ci95) / unit.newtons,
                           unit.decimals);
    };
    rows.push_back(row_view(
        text_at(one, result_key::scenario_name),
        {csv_number(number_at(one, result_key::scenario_weight)),
         mean(result_key::mean_load, result_key::mean_load_ci95),
         mean(result_key::cycle_load, result_key::cycle_load_ci95), load(result_key::lindqvist_total)}));
  }
  return table_view("Scenarios",
                    {"weight", "simulated, " + unit.name, "cycle, " + unit.name, "Lindqvist, " + unit.name},
                    rows);
}

Json cycle_table(const RankedDesign& ranked, const LoadUnit& unit) {
  const Json& result = ranked.evaluation.result;
  if (!std::isfinite(number_at(result, result_key::cycle_load))) return nullptr;
  const auto load = [&](const char* part) {
    return fixed(number_at(result, result_key::cycle_part(part)) / unit.newtons, unit.decimals);
  };
  const auto interval = [&](double value, double half) {
    return with_interval(value / unit.newtons, half / unit.newtons, unit.decimals);
  };
  Json rows = Json::array();
  rows.push_back(row_view("Mean \u00b1 95\u00a0%", {interval(ranked.cycle_load, ranked.cycle_ci95)}));
  const std::pair<const char*, const char*> parts[] = {{"Crushing", "crushing"},
                                                       {"Bending", "bending"},
                                                       {"Friction", "friction"},
                                                       {"Submersion", "submersion"},
                                                       {"Water", "water"}};
  for (const auto& [label, key] : parts) rows.push_back(row_view(label, {load(key)}));
  if (std::isfinite(ranked.solver_load))
    rows.push_back(row_view("Simulated", {interval(ranked.solver_load, ranked.solver_ci95)}));
  if (std::isfinite(ranked.difference_ci95))
    rows.push_back(
        row_view("Corrected by simulation / cycle", {interval(ranked.mean_load, ranked.mean_load_ci95)}));
  return table_view("Breaking cycle", {"full scale, " + unit.name}, rows);
}

Json margins_view(const Json& result) {
  Json list = Json::array();
  const Json& margins = part_at(result, result_key::margins);
  if (!margins.is_object()) return list;
  std::map<std::string, std::string> sentences = words_at(result, result_key::margin_sentences);
  for (const auto& [name, value] : margins.items()) {
    const double margin = value.is_number() ? value.get<double>() : std::nan("");
    list.push_back({{"label", name},
                    {"kind", margin < 0.0 ? "negative" : "positive"},
                    {"value", fixed(margin, 2)},
                    {"words", sentences[name]}});
  }
  return list;
}

// "key figure: value" pairs in small print.
class Facts {
 public:
  void add(const std::string& name, const std::string& value) { list_.push_back({name, value}); }
  void add(const std::string& name, double value, int decimals, const std::string& unit = "") {
    if (std::isfinite(value)) add(name, fixed(value, decimals) + (unit.empty() ? "" : "\u00a0" + unit));
  }
  void count(const std::string& name, double value) {
    if (std::isfinite(value)) add(name, with_thousands(std::llround(value)));
  }
  Json view(const std::string& title) const {
    Json json = facts_view(list_, true);
    json["title"] = title;
    return json;
  }

 private:
  std::vector<Fact> list_;
};

Json ice_facts(const Json& result, double lambda) {
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
  return facts.view("Ice");
}

Json simulation_facts(const Json& result, double wall_seconds) {
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
  facts.add("Tensile strength of bonds, model", number_at(result, result_key::tensile_strength) / 1e3, 1,
            "kPa");
  facts.add("Crushing pressure, model", number_at(result, result_key::crushing_pressure) / 1e3, 1, "kPa");
  facts.add("Flexural strength of the simulated ice, full scale",
            number_at(result, result_key::simulated_flexural_strength) / 1e3, 0, "kPa");
  facts.add("Model scale", "1\u2009:\u2009" + fixed(number_at(result, result_key::lambda), 0));
  facts.add("Wall time", duration(wall_seconds));
  facts.count("Ranks", number_at(result, result_key::ranks));
  facts.add("Time per bond and step", number_at(result, result_key::ns_per_bond), 2, "ns");
  return facts.view("Simulation");
}

Json pictures_view(const DesignContent& design) {
  Json list = Json::array();
  for (const Picture& picture : design.pictures) {
    const bool known = std::isfinite(picture.advance), scaled = std::isfinite(design.lambda);
    list.push_back({{"png", base64(read_text_file(picture.path))},
                    {"advance", !known   ? "advance unknown"
                                : scaled ? fixed(picture.advance * design.lambda, 1) + "\u00a0m"
                                         : fixed(picture.advance, 2) + "\u00a0m"},
                    {"model", !known   ? ""
                              : scaled ? "(model " + fixed(picture.advance, 2) + "\u00a0m)"
                                       : "model"}});
  }
  return list;
}

// What one more run of it would take.
std::string cost(const RankedDesign& ranked) {
  const double seconds = ranked.evaluation.wall_seconds;
  if (!(seconds > 0.0)) return {};
  const Json& result = ranked.evaluation.result;
  const double to = number_at(result, result_key::steady_to);
  const double ranks = number_at(result, result_key::ranks);
  std::string words = "It took " + duration(seconds);
  if (std::isfinite(ranks)) words += " on " + fixed(ranks, 0) + (ranks == 1.0 ? " core" : " cores");
  if (!part_at(result, result_key::simulation).is_object() || !(to > 0.0)) return words + ".";
  return words + " for " + fixed(to, 0) + "\u00a0m; 100\u00a0m more take about " +
         duration(100.0 * seconds / to) + ", half the spacing about 16 times as long.";
}

std::string command(const ReportContent& content, const RankedDesign& ranked) {
  // The directory knows how far a race has sailed each design.
  const std::string study = content.study.ranking.race.given() ? content.study.directory
                            : content.study.file.empty()       ? content.study.directory + "/study.json"
                                                               : content.study.file;
  const std::string name = ranked.evaluation.name;
  const std::string words = shell_word(study) + " --design " + shell_word(name);
  if (part_at(ranked.evaluation.result, result_key::simulation).is_object())
    return "icebow simulate " + words + " --out out/" + (shell_word(name) == name ? name : "design");
  if (part_at(ranked.evaluation.result, result_key::cycle).is_object()) return "icebow cycle " + words;
  return "icebow resistance " + words;
}

std::vector<std::string> cautions(const Json& result) {
  std::vector<std::string> words;
  if (is_false_at(result, result_key::lindqvist_valid))
    words.push_back("Lindqvist's formula does not apply: " + text_at(result, result_key::lindqvist_reason));
  const std::string caution = text_at(result, result_key::lindqvist_caution);
  if (!caution.empty()) words.push_back("Lindqvist's formula: " + caution);
  const std::string unlike = unlike_ice_words(result);
  if (!unlike.empty()) words.push_back("\u2020 The two loads are of unlike ices: " + unlike + ".");
  return words;
}

Json fact_lists(const RankedDesign& ranked, double lambda) {
  Json lists = Json::array();
  const Json& result = ranked.evaluation.result;
  if (std::isfinite(number_at(result, result_key::model_mean_load)))
    lists.push_back(ice_facts(result, lambda));
  if (part_at(result, result_key::simulation).is_object())
    lists.push_back(simulation_facts(result, ranked.evaluation.wall_seconds));
  return lists;
}

}  // namespace

Json card_head_view(const ReportContent& content, std::size_t i) {
  const RankedDesign& ranked = content.row(i);
  const double p =
      ranked.rank > 1 ? compared_with(ranked, content.row(0), content.study.ranking.rank_by).p : 0.0;
  return {{"id", content.designs[i].id},
          {"rank", std::to_string(ranked.rank)},
          {"name", ranked.evaluation.name},
          {"load", std::isfinite(ranked.value) ? value_in_words(ranked, content.study.ranking) : ""},
          {"tied", p >= told_apart_below ? "not told apart from 1" : ""}};
}

Json card_body_view(const ReportContent& content, std::size_t i) {
  const RankedDesign& ranked = content.row(i);
  const DesignContent& design = content.designs[i];
  const Json& result = ranked.evaluation.result;
  const double lambda = std::isfinite(design.lambda) ? design.lambda : 1.0;
  const Json margins = margins_view(result);
  return {
      {"name", ranked.evaluation.name},
      {"lines_plan", design.lines_plan},
      {"no_lines_plan", design.drawings_left_out
                            ? "The lines plan is in the design's directory; it was left out to keep "
                              "this file small."
                            : "No lines plan was written for this design; icebow hull draws one."},
      {"imported", imported_note(result)},
      {"cautions", cautions(result)},
      {"tables", tables_view({angles_table(result), loads_table(content, ranked, lambda),
                              lindqvist_table(result, ranked, content.unit),
                              cycle_table(ranked, content.unit), scenarios_table(result, content.unit)})},
      {"voyage", design.voyage},
      {"process", process_view(result, lambda)},
      {"has_pictures", !design.pictures.empty()},
      {"picture_colours", "cracks by their kind, a tint for each floe; each picture explains its colours"},
      {"pictures", pictures_view(design)},
      {"left_out", design.pictures_left_out == 0
                       ? ""
                       : std::to_string(design.pictures_left_out) +
                             " more in the design's directory; left out to keep this file small."},
      {"animation", design.animation.empty() ? "" : base64(read_text_file(design.animation))},
      {"has_margins", !margins.empty()},
      {"margins", margins},
      {"fact_lists", fact_lists(ranked, lambda)},
      {"of_first_run", first_run_in_words(content.study, ranked.evaluation)},
      {"reproduce", command(content, ranked)},
      {"cost", cost(ranked)}};
}

}  // namespace icebow
