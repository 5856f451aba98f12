// ranking.csv for programs, ranking.md for people.
#include "reports/tables/table_report.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "base/csv_cell.h"
#include "base/json_fields.h"
#include "base/json_words.h"
#include "reports/content/all_runs.h"
#include "reports/content/comparison.h"
#include "reports/content/conditions.h"
#include "reports/content/load_unit.h"
#include "reports/content/verdict.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"

namespace icebow {
namespace {

const char* const angles[] = {"stem", "waterline", "buttock", "flare"};

// Every parameter any design of the study was given.
std::set<std::string> parameter_names(const Ranking& ranking) {
  std::set<std::string> names;
  for (const RankedDesign& row : ranking.rows)
    for (const auto& [name, value] : row.evaluation.parameters) names.insert(name);
  for (const RankedDesign& row : ranking.rows)
    for (const auto& [name, word] : words_at(row.evaluation.result, result_key::choices)) names.insert(name);
  return names;
}

// Of a study over scenarios, in the order of the results.
std::vector<std::string> scenario_names(const Ranking& ranking) {
  std::vector<std::string> names;
  for (const RankedDesign& row : ranking.rows)
    if (names.empty())
      for (const ScenarioLoad& load : scenario_loads(row.evaluation.result)) names.push_back(load.name);
  return names;
}

// Computing time of all runs that are ok.
double wall_seconds(const StudyResults& study, const Evaluation& design) {
  const auto repeats = study.repeats.find(design.name);
  if (repeats == study.repeats.end()) return design.wall_seconds;
  double sum = 0.0;
  for (const Evaluation& run : repeats->second) sum += run.wall_seconds;
  return sum;
}

// `p_best`: how often a mean equal to the best one would look so unlike.
std::string csv_row(const StudyResults& study, const RankedDesign& row, double p_best, std::size_t scenarios,
                    const std::set<std::string>& parameters) {
  const Evaluation& e = row.evaluation;
  const auto of_runs = [&](const char* pointer, OverRuns how) {
    return ',' + csv_number(over_runs(study, e, pointer, how));
  };
  const auto result = [&](const char* pointer) { return ',' + csv_number(number_at(e.result, pointer)); };
  std::string line =
      (row.rank > 0 ? std::to_string(row.rank) : "") + ',' + csv_cell(e.name) + ',' + to_string(e.status);
  for (const char* angle : angles) line += ',' + csv_number(measured_or_requested(e.result, angle));
  line += ',' + csv_number(row.mean_load) + ',' + csv_number(row.mean_load_ci95);
  line += of_runs(result_key::max_load, OverRuns::highest) + of_runs(result_key::q95_load, OverRuns::mean);
  const double model_mean = over_runs(study, e, result_key::model_mean_load, OverRuns::mean);
  line += of_runs(result_key::std_load, OverRuns::mean) + ',' + csv_number(model_mean);
  line += row.runs > 1 && runs_of(study, e) > 1
              ? ',' + csv_number(row.ci95_repeats * model_mean / row.mean_load)
              : result(result_key::model_mean_load_ci95);
  line += result(result_key::lindqvist_crushing) + result(result_key::lindqvist_bending) +
          result(result_key::lindqvist_submersion);
  line += ',' + csv_number(row.lindqvist_breaking) + result(result_key::lindqvist_total) + ',' +
          csv_number(row.ratio);
  line += std::string(",") + (row.tied_with_best ? "1" : "0") + ',' + (row.tied_with_next ? "1" : "0");
  line +=
      ',' + std::to_string(row.runs) + ',' + csv_number(row.ci95_series) + ',' + csv_number(row.ci95_repeats);
  for (const double load : {row.cycle_load, row.cycle_ci95, row.solver_load, row.solver_ci95})
    line += ',' + csv_number(load);
  line += ',' + csv_number(p_best) + of_runs(result_key::effective_samples, OverRuns::sum) + ',' +
          csv_cell(text_at(e.result, result_key::lindqvist_caution)) + ',' +
          csv_cell(unlike_ice_words(e.result));
  line += ',' + csv_number(wall_seconds(study, e)) + ',' + csv_cell(e.reason);
  const std::vector<ScenarioLoad> loads = scenario_loads(e.result);
  for (std::size_t k = 0; k < scenarios; ++k)
    line += ',' + (k < loads.size() ? csv_number(loads[k].mean) : "") + ',' +
            (k < loads.size() ? csv_number(loads[k].ci95) : "");
  std::map<std::string, std::string> choices = words_at(e.result, result_key::choices);
  for (const std::string& name : parameters) {
    const auto it = e.parameters.find(name);
    line += ',' + (it == e.parameters.end() ? csv_cell(choices[name]) : csv_number(it->second));
  }
  return line + '\n';
}

// `confirmed`: with what the cycle and the simulation say, of which the mean load is made.
std::string markdown_row(const StudyResults& study, const RankedDesign& row, const LoadUnit& unit,
                         bool confirmed) {
  const Json& result = row.evaluation.result;
  const auto load = [&](double newtons) { return fixed(newtons / unit.newtons, unit.decimals); };
  std::string line =
      "| " + (row.rank > 0 ? std::to_string(row.rank) : "\u2013") + (row.tied_with_best ? " \u2248" : "");
  line += " | " + markdown_escaped(row.evaluation.name);
  for (const char* angle : angles) line += " | " + fixed(measured_or_requested(result, angle), 1);
  const auto cell = [&](double mean, double ci95) {
    return " | " + with_interval(mean / unit.newtons, ci95 / unit.newtons, unit.decimals);
  };
  line += cell(row.mean_load, row.mean_load_ci95);
  if (confirmed) line += cell(row.cycle_load, row.cycle_ci95) + cell(row.solver_load, row.solver_ci95);
  line += " | " + load(over_runs(study, row.evaluation, result_key::max_load, OverRuns::highest)) + " | " +
          load(row.lindqvist);
  return line + " | " + fixed(row.ratio, 2) + " |\n";
}

std::string markdown_unranked(const Ranking& ranking) {
  std::string text;
  for (const RankedDesign& row : ranking.rows) {
    if (row.rank > 0) continue;
    text += "- **" + markdown_escaped(row.evaluation.name) + "** " + to_string(row.evaluation.status);
    if (!row.evaluation.reason.empty()) text += ": " + markdown_escaped(row.evaluation.reason);
    text += '\n';
  }
  return text.empty() ? text : "\n## Not ranked\n\n" + text;
}

std::string markdown_provenance(const StudyResults& study) {
  std::string text = "\n## Provenance\n\n";
  const std::pair<const char*, std::string> facts[] = {
      {"Command", study.command.empty() ? "" : '`' + study.command + '`'},
      {"Version", study.version},
      {"Started", study.started},
      {"Host", study.host},
      {"Seed", study.seed},
      {"Designs evaluated", std::to_string(study.evaluated())},
      {"Wall time, sum over designs", duration(study.wall_seconds)}};
  for (const auto& [name, value] : facts)
    if (!value.empty()) text += std::string("- ") + name + ": " + value + '\n';
  return text;
}

}  // namespace

std::string ranking_csv(const StudyResults& study) {
  const std::set<std::string> parameters = parameter_names(study.ranking);
  std::string text =
      "rank,design,status,stem_deg,waterline_deg,buttock_deg,flare_deg,mean_load_N,mean_load_ci95_N,max_load_"
      "N,"
      "q95_load_N,std_load_N,model_mean_load_N,model_mean_load_ci95_N,lindqvist_crushing_N,lindqvist_bending_"
      "N,"
      "lindqvist_submersion_N,lindqvist_breaking_N,lindqvist_total_N,ratio,tied_with_best,tied_with_next,"
      "runs,ci95_series_N,ci95_repeats_N,cycle_load_N,cycle_load_ci95_N,solver_load_N,solver_load_ci95_N,"
      "p_best,samples,lindqvist_caution,unlike_ice,wall_s,reason";
  const std::vector<std::string> scenarios = scenario_names(study.ranking);
  for (const std::string& name : scenarios)
    text += ',' + csv_cell("scenario " + name + "_N") + ',' + csv_cell("scenario " + name + "_ci95_N");
  for (const std::string& name : parameters) text += ',' + csv_cell(name);
  text += '\n';
  for (const RankedDesign& row : study.ranking.rows) {
    const bool compared = row.rank > 1;
    const double p =
        compared ? compared_with(row, study.ranking.rows.front(), study.ranking.rank_by).p : std::nan("");
    text += csv_row(study, row, p, scenarios.size(), parameters);
  }
  return text;
}

std::string ranking_markdown(const StudyResults& study) {
  const LoadUnit unit = load_unit(study.ranking);
  const Verdict words = verdict(study);
  std::string text = "# " + markdown_escaped(study.name) + "\n\n";
  if (!study.purpose.empty()) text += markdown_escaped(study.purpose) + "\n\n";
  text += "**" + markdown_escaped(words.headline) + "**\n";
  const std::string ice = conditions(study).ice;
  if (!ice.empty()) text += markdown_escaped(ice) + '\n';
  if (!words.next.empty()) text += "Next: " + markdown_escaped(words.next) + '\n';
  for (const std::string& remark : words.remarks) text += markdown_escaped(remark) + '\n';
  if (study.ranked() > 0) {
    const bool confirmed = study.ranking.confirmed.designs > 0;
    text +=
        "\n| rank | design | stem, deg | waterline, deg | buttock, deg | flare, deg | mean load \u00b1 "
        "95\u00a0%, " +
        unit.name + (confirmed ? " | cycle, " + unit.name + " | simulated, " + unit.name : "") + " | peak, " +
        unit.name + " | Lindqvist " + compared_part(study.ranking) + ", " + unit.name +
        " | ratio |\n|--:|:--|--:|--:|--:|--:|--:|--:|--:|--:|" + (confirmed ? "--:|--:|" : "") + "\n";
    for (const RankedDesign& row : study.ranking.rows)
      if (row.rank > 0) text += markdown_row(study, row, unit, confirmed);
    text +=
        "\nFull scale. \u2248: not told apart from rank 1 (Welch's test, p of 0.05 or more). Ratio: mean "
        "load over "
        "Lindqvist's " +
        compared_part(study.ranking) + (compared_part(study.ranking) == "total" ? ".\n" : " part.\n");
  }
  return text + markdown_unranked(study.ranking) + markdown_provenance(study);
}

void write_table_reports(const std::string& study_directory) {
  const StudyResults study = read_study_results(study_directory);
  const std::filesystem::path directory(study_directory);
  write_text_file((directory / "ranking.csv").string(), ranking_csv(study));
  write_text_file((directory / "ranking.md").string(), ranking_markdown(study));
}

}  // namespace icebow
