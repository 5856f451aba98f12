#include "cli/ranking_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/json_fields.h"
#include "base/json_words.h"
#include "cli/process_text.h"
#include "cli/text_table.h"
#include "reports/content/verdict.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/look/stored_design.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

constexpr std::size_t most_scenario_columns = 6;  // icebow export has them all

std::string kilonewtons(double newtons) {
  return decimals(newtons / 1e3, 1);
}

std::string interval(const RankedDesign& row) {
  if (!std::isfinite(row.mean_load)) return "-";
  const std::string half = std::isfinite(row.mean_load_ci95) ? kilonewtons(row.mean_load_ci95) : "?";
  const std::string runs = row.runs > 1 ? " (" + std::to_string(row.runs) + " runs)" : "";
  return kilonewtons(row.mean_load) + " \u00b1 " + half + runs;
}

std::string simulated(const RankedDesign& row) {
  if (!std::isfinite(row.solver_load)) return "";
  return kilonewtons(row.solver_load) + " \u00b1 " +
         (std::isfinite(row.solver_ci95) ? kilonewtons(row.solver_ci95) : "?");
}

// How the mean loads of a study that confirms designs came about.
std::string confirmation_text(const Ranking& ranking) {
  const RatioFit& fit = ranking.confirmed;
  if (fit.designs == 0) return "";
  std::string text;
  for (const std::string& words : ranking.disagreements) text += words + "\n";
  text += "mean load = cycle x " + decimals(std::exp(fit.constant), 2) +
          ", the ratio of simulation and cycle over " + std::to_string(fit.designs) + " designs";
  if (!fit.variable.empty())
    text += ", x exp(" + brief(fit.slope) + " (" + fit.variable + " - " + brief(fit.middle) + "))";
  if (std::isfinite(fit.error))
    text += "; a design left out is met within " + decimals(100.0 * fit.error, 0) +
            " % (by a constant alone " + decimals(100.0 * fit.error_of_constant, 0) + " %)";
  return text + "\nTies are told without the error of the ratio that all designs share.\n\n";
}

// Variables that differ between the ranked designs, by pointer.
std::vector<std::string> varied(const Ranking& ranking) {
  std::map<std::string, std::set<Json>> values;
  for (const RankedDesign& row : ranking.rows) {
    if (row.rank == 0) continue;
    for (const auto& [pointer, value] : row.evaluation.parameters) values[pointer].insert(value);
    for (const auto& [pointer, word] : words_at(row.evaluation.result, result_key::choices))
      values[pointer].insert(word);
  }
  std::vector<std::string> pointers;
  for (const auto& [pointer, different] : values)
    if (different.size() > 1) pointers.push_back(pointer);
  return pointers;
}

std::vector<std::string> parameter_cells(const Evaluation& e, const std::vector<std::string>& pointers) {
  std::vector<std::string> cells;
  std::map<std::string, std::string> choices = words_at(e.result, result_key::choices);
  for (const std::string& pointer : pointers) {
    const auto found = e.parameters.find(pointer);
    cells.push_back(found == e.parameters.end() ? choices[pointer] : brief(found->second));
  }
  return cells;
}

// Columns that say nothing of any design, like the mean load in a study of the formula alone, are left out.
std::vector<std::vector<std::string>> without_empty_columns(
    const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> kept(rows.size());
  for (std::size_t column = 0; column < rows[0].size(); ++column) {
    bool says_something = rows.size() < 2;
    for (std::size_t i = 1; i < rows.size(); ++i)
      says_something = says_something || (!rows[i][column].empty() && rows[i][column] != "-");
    for (std::size_t i = 0; i < rows.size() && says_something; ++i) kept[i].push_back(rows[i][column]);
  }
  return kept;
}

// Of a study over scenarios, the names of these, in order.
std::vector<std::string> scenario_names(const Ranking& ranking) {
  std::vector<std::string> names;
  for (const RankedDesign& row : ranking.rows) {
    if (row.rank == 0 || !names.empty()) continue;
    for (const ScenarioLoad& load : scenario_loads(row.evaluation.result)) names.push_back(load.name);
  }
  return names;
}

std::vector<std::string> scenario_cells(const RankedDesign& row, std::size_t scenarios) {
  std::vector<std::string> cells;
  for (const ScenarioLoad& load : scenario_loads(row.evaluation.result))
    cells.push_back(kilonewtons(load.mean) +
                    (std::isfinite(load.ci95) ? " \u00b1 " + kilonewtons(load.ci95) : ""));
  cells.resize(scenarios);
  return cells;
}

std::string tie(const RankedDesign& row, const RaceRecord& race) {
  const std::string place = place_in_race(race, row.evaluation.name);
  if (!place.empty()) return place;
  if (row.tied_with_best && row.rank > 1) return "with the best";
  return row.tied_with_next ? "with the next" : "";
}

std::string last_word(const std::string& pointer) {
  return pointer.substr(pointer.rfind('/') + 1);
}

std::string second_cell(const RankedDesign& row) {
  if (!std::isfinite(row.second)) return "-";
  const std::string half = std::isfinite(row.second_ci95) ? brief(row.second_ci95) : "?";
  return brief(row.second) + (row.second_ci95 == 0.0 ? "" : " \u00b1 " + half);
}

std::string front_cell(const RankedDesign& row) {
  return row.front == FrontPlace::front ? "front" : row.front == FrontPlace::open ? "perhaps" : "";
}

// What the formula says of its own range, once for each sentence.
std::string cautions(const Ranking& ranking) {
  std::map<std::string, std::vector<std::string>> designs;
  for (const RankedDesign& row : ranking.rows) {
    const std::string caution = text_at(row.evaluation.result, result_key::lindqvist_caution);
    if (row.rank > 0 && !caution.empty()) designs[caution].push_back(row.evaluation.name);
  }
  std::string text;
  for (const auto& [caution, names] : designs)
    text += "\ncaution: Lindqvist's formula for " +
            (names.size() == 1 ? names.front()
                               : std::to_string(names.size()) + " designs, first " + names.front()) +
            ": " + caution + "\n";
  return text;
}

}  // namespace

Ranking read_ranking(const std::string& directory) {
  return stored_ranking(open_store_of(directory));
}

std::string ranking_text(const Ranking& ranking) {
  const bool confirmed = ranking.confirmed.designs > 0;
  std::vector<std::vector<std::string>> rows = {{"design", "rank", "mean load, kN",
                                                 "Lindqvist " + compared_part(ranking) + ", kN", "ratio",
                                                 ranking.race.given() ? "race" : "tied"}};
  if (confirmed) rows[0].insert(rows[0].begin() + 3, {"cycle, kN", "simulated, kN"});
  const std::vector<std::string> scenarios = scenario_names(ranking);
  for (std::size_t k = 0; k < scenarios.size() && scenarios.size() <= most_scenario_columns; ++k)
    rows[0].insert(rows[0].begin() + 3 + static_cast<std::ptrdiff_t>(k),
                   scenarios[k] + (confirmed ? " by cycle, kN" : ", kN"));
  const bool by_pointer = ranking.rank_by[0] == '/';
  if (by_pointer) rows[0].insert(rows[0].begin() + 2, last_word(ranking.rank_by) + ", kN");
  const bool two = ranking.objective.given();
  if (two) rows[0].insert(rows[0].begin() + 3, {last_word(ranking.objective.by), "front"});
  const std::vector<std::string> pointers = varied(ranking);
  std::vector<std::string> names;
  for (const std::string& pointer : pointers) names.push_back(last_word(pointer));
  rows[0].insert(rows[0].begin() + 1, names.begin(), names.end());
  std::string others;
  for (const RankedDesign& row : ranking.rows) {
    const Evaluation& e = row.evaluation;
    if (row.rank == 0) {
      others += e.name + ": " + to_string(e.status) + (e.reason.empty() ? "" : ": " + e.reason) + "\n";
      continue;
    }
    rows.push_back({e.name, std::to_string(row.rank), interval(row), kilonewtons(row.lindqvist),
                    decimals(row.ratio, 2), tie(row, ranking.race)});
    if (confirmed)
      rows.back().insert(
          rows.back().begin() + 3,
          {kilonewtons(row.cycle_load) + " \u00b1 " + kilonewtons(row.cycle_ci95), simulated(row)});
    const std::vector<std::string> parts = scenario_cells(row, scenarios.size());
    if (scenarios.size() <= most_scenario_columns)
      rows.back().insert(rows.back().begin() + 3, parts.begin(), parts.end());
    if (by_pointer) rows.back().insert(rows.back().begin() + 2, kilonewtons(row.value));
    if (two) rows.back().insert(rows.back().begin() + 3, {second_cell(row), front_cell(row)});
    const std::vector<std::string> cells = parameter_cells(e, pointers);
    rows.back().insert(rows.back().begin() + 1, cells.begin(), cells.end());
  }
  const std::string race = race_in_words(ranking.race);
  std::string text = (race.empty() ? "" : race + "\n\n") + confirmation_text(ranking) + "ranked by " +
                     ranking.rank_by + ", full scale, \u00b1 95 % interval of the mean\n\n" +
                     text_table(without_empty_columns(rows));
  if (two) text += "\n" + front_in_words(ranking) + "\n";
  const std::string process = process_table(ranking);
  if (!process.empty())
    text += "\nhow the ice broke: cracks by kind; lengths over the thickness h\n\n" + process;
  text += cautions(ranking);
  for (const std::string& warning : ranking.warnings)
    if (race.empty() || warning.rfind("not told apart", 0) != 0)  // a race says itself who may be the best
      text += "\nwarning: " + warning + "\n";
  if (!others.empty()) text += "\nnot ranked\n" + others;
  if (std::isfinite(ranking.spearman)) {
    text += "\nrank correlation of mean load and formula: " + decimals(ranking.spearman, 2) + " (" +
            std::to_string(ranking.spearman_n) + " designs)\n";
  }
  return text;
}

std::string order_text(const std::string& directory, const Ranking& ranking) {
  const bool simulated = std::any_of(ranking.rows.begin(), ranking.rows.end(), [](const RankedDesign& row) {
    return part_at(row.evaluation.result, result_key::simulation).is_object();
  });
  const std::string words = simulated ? order_in_words(read_study_results(directory)) : "";
  return words.empty() ? words : "\n" + words + "\n";
}

}  // namespace icebow
