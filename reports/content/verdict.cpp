#include "reports/content/verdict.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "base/json_fields.h"
#include "reports/content/all_runs.h"
#include "reports/content/comparison.h"
#include "reports/content/conditions.h"
#include "reports/content/load_unit.h"
#include "reports/text/text_format.h"
#include "study/evaluate/result_keys.h"
#include "study/spec/document_keys.h"

namespace icebow {
namespace {

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

// "stem 25.6°, waterline 19.1°, buttock 21.2°": those that differ within the ranking.
std::string angles_in_words(const RankedDesign& row, const Ranking& ranking) {
  std::vector<std::string> words;
  for (const char* angle : {"stem", "waterline", "buttock", "flare"}) {
    const double own = measured_or_requested(row.evaluation.result, angle);
    const bool varies = std::any_of(ranking.rows.begin(), ranking.rows.end(), [&](const RankedDesign& other) {
      return other.rank > 0 && std::fabs(measured_or_requested(other.evaluation.result, angle) - own) > 0.1;
    });
    if (varies && std::isfinite(own)) words.push_back(std::string(angle) + " " + fixed(own, 1) + "\u00b0");
  }
  return listed(words, 4);
}

const RankedDesign* baseline_of(const StudyResults& study) {
  for (const RankedDesign& row : study.ranking.rows)
    if (row.rank > 0 && row.evaluation.name == "baseline") return &row;
  return nullptr;
}

// "17 ± 6 % below the baseline": `value` against what it is compared with, with the half width of the
// difference's interval where there is one. Of a number that is not positive there is no percentage.
std::string apart_in_words(double value, double other, double ci95, const std::string& name,
                           const LoadUnit& unit) {
  if (value == other && ci95 == 0.0) return "the same as " + name;
  if (!(other > 0.0))
    return load_in_words(std::fabs(value - other), unit) + (value < other ? " below " : " above ") + name;
  const double share = 100.0 * (value / other - 1.0), half = std::fabs(100.0 * ci95 / other);
  const std::string error =
      !(half > 0.0) || !std::isfinite(half) ? "" : "\u00a0\u00b1\u00a0" + fixed(half, half < 0.95 ? 1 : 0);
  const int decimals = ci95 == 0.0 && std::fabs(share) < 0.95 ? 1 : 0;
  return fixed(std::fabs(share), decimals) + error + "\u00a0% " + (share < 0.0 ? "below " : "above ") + name;
}

// A number without sampling error: equal ones stay equal however often they are evaluated.
bool is_exact(const RankedDesign& row, const StudyResults& study) {
  return compared_with(row, row, study.ranking.rank_by).ci95 == 0.0;
}

// A race says itself who may be the best.
std::string tie_clause(const StudyResults& study, int ranked) {
  if (study.ranking.race.given() || ranked == 0) return "";
  const int tied = static_cast<int>(std::count_if(
      study.ranking.rows.begin(), study.ranking.rows.begin() + ranked, [&](const RankedDesign& row) {
        return row.rank > 1 &&
               compared_with(row, study.ranking.rows[0], study.ranking.rank_by).p >= told_apart_below;
      }));
  if (tied == 0) return "";
  const std::string others = "; " + counted(static_cast<std::size_t>(tied), "other design");
  if (is_exact(study.ranking.rows.front(), study))
    return others + (tied == 1 ? " has" : " have") + " the same";
  return others + " cannot be told apart from it";
}

// The simulations that confirm fix the order, but not the level.
bool level_is_open(const StudyResults& study, int ranked) {
  if (ranked == 0 || study.ranking.confirmed.designs == 0) return false;
  const RankedDesign& best = study.ranking.rows.front();
  return value_ci95(best, study.ranking.rank_by) > std::fabs(best.value);
}

std::string open_level(const StudyResults& study) {
  return "The level of the loads is not known: its interval is wider than the mean after " +
         counted(static_cast<std::size_t>(study.ranking.confirmed.designs), "simulation") +
         ". The order is the breaking cycle's.";
}

std::string sentence(std::string words) {
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words.back() == '.' ? words : words + '.';
}

// What is claimed of the design that the headline names: no more than a race has decided.
std::string claim(const StudyResults& study) {
  const RaceRecord& race = study.ranking.race;
  const std::string quantity = ranked_quantity(study.ranking.rank_by) + over_scenarios(study.document);
  if (!race.given() || (race.state == RaceState::decided && race.legs.back().in.size() == 1))
    return " has the lowest " + quantity;
  if (race.state == RaceState::decided)
    return " has the lowest " + quantity + " within " + fixed(100.0 * race.best_within, 0) + "\u00a0%";
  return " leads with a " + quantity + " of";
}

std::string open_race_clause(const RaceRecord& race) {
  if (!race.given() || race.state == RaceState::decided) return "";
  const std::size_t others = race.legs.back().in.size() - 1;
  return "; the race is not decided: " + counted(others, "other design") + " may be lower";
}

// Of one design nothing is the lowest.
std::string headline_of_one(const StudyResults& study) {
  const RankedDesign& only = study.ranking.rows.front();
  return only.evaluation.name + " is the only design with a rank: " + ranked_quantity(study.ranking.rank_by) +
         over_scenarios(study.document) + ' ' + value_in_words(only, study.ranking) + '.';
}

std::string headline(const StudyResults& study, int ranked) {
  if (ranked == 1 && !study.ranking.race.given()) return headline_of_one(study);
  if (ranked > 0) {
    const RankedDesign& best = *best_of(study.ranking);
    const std::string angles = angles_in_words(best, study.ranking);
    const std::string versus = best.evaluation.name == "baseline" ? "" : versus_in_words(best, study);
    return best.evaluation.name + (angles.empty() ? "" : " (" + angles + ")") + claim(study) +
           (open_race_clause(study.ranking.race).empty() ? ", " : " ") + value_in_words(best, study.ranking) +
           (versus.empty() ? "" : ", " + versus) + tie_clause(study, ranked) +
           open_race_clause(study.ranking.race) + '.';
  }
  if (study.evaluated() == 0) return "No design has been evaluated yet.";
  if (study.ok == 0) return "No design could be ranked: each was infeasible or failed.";
  return "No design could be ranked: no result holds the " + ranked_quantity(study.ranking.rank_by) + '.';
}

std::string no_order(const StudyResults& study, const TooShort& records) {
  return (study.ranked() == 1 ? "This study does not know the load of this bow: "
                              : "This study does not rank these bows: ") +
         records.reason + ".";
}

std::string longer_records(const TooShort& records) {
  if (!std::isfinite(records.advance_needed))
    return "Sail farther (operation.advance_m), or run each design several times (repeats).";
  return "Sail " + fixed(records.advance_needed, 0) + "\u00a0m instead of " + fixed(records.advance, 0) +
         "\u00a0m (operation.advance_m): about " + duration(records.seconds_needed) + " of computing.";
}

// "stem_deg" of the best design where it lies at an end of what the study allowed it; empty where inside.
std::string at_its_bound(const StudyResults& study) {
  const Json& variables = part_at(study.document, document_key::method_variables);
  if (!variables.is_object()) return {};
  const auto& parameters = study.ranking.rows.front().evaluation.parameters;
  for (const auto& [pointer, range] : variables.items()) {
    const auto own = parameters.find(pointer);
    const double low = number_at(range, document_key::variable_min),
                 high = number_at(range, document_key::variable_max);
    if (own == parameters.end() || !(high > low)) continue;
    if (std::min(own->second - low, high - own->second) < 0.02 * (high - low)) return pointer;
  }
  return {};
}

std::string next_step(const StudyResults& study, int ranked, const TooShort& records) {
  if (!study.finished()) return "Give the same command again: it goes on where the study stopped.";
  if (ranked == 0) return "Read the reasons below: each names the parameter to change.";
  const RaceRecord& race = study.ranking.race;
  if (race.given() && race.state != RaceState::decided)
    return "Raise decide.budget_core_h or decide.longest_m: the same command then sails the open voyages on.";
  if (!records.reason.empty() && !race.given()) return longer_records(records);
  if (level_is_open(study, ranked))
    return "Simulate more designs for the level: raise confirm.best or confirm.spread.";
  const Ranking& ranking = study.ranking;
  const std::string bound = at_its_bound(study);
  if (!bound.empty())
    return "The best design lies at an end of the range of " + bound + ": widen it, and sweep again.";
  const std::string& best = ranking.rows.front().evaluation.name;
  const bool sails = std::isfinite(ranking.rows.front().cycle_load);
  const bool simulated = part_at(ranking.rows.front().evaluation.result, result_key::simulation).is_object();
  const bool by_cycle =
      (!over_scenarios(study.document).empty() && !simulated) || ranking.confirmed.designs > 0;
  if (sails && by_cycle && !tie_clause(study, ranked).empty())
    return "Tell the leaders apart: sail more voyages (cycle.voyages).";
  if (ranking.confirmed.designs == 0 && sails && over_scenarios(study.document).empty())
    return "Confirm the order by the simulation: add \"confirm\": {\"best\": 3, \"spread\": 2} to the study.";
  if (ranking.rank_by == "lindqvist_breaking")
    return "The formula knows two of the four angles: add \"cycle\" to \"evaluators\", which sees the whole "
           "hull.";
  if (!is_exact(ranking.rows.front(), study) && !tie_clause(study, ranked).empty())
    return std::string("Tell the leaders apart: ") +
           (run_counts(study).most > 1 ? "repeat them more often" : "repeat them") +
           " (\"repeats\") or sail farther (operation.advance_m).";
  if (!part_at(ranking.rows.front().evaluation.result, result_key::simulation).is_object())
    return "Put a second evaluator beside it: \"cycle\" in \"evaluators\" sees the whole hull within a "
           "second.";
  return "Simulate " + best +
         " on a finer lattice (solver.layers): the level of its load, and the order, may change.";
}

// Which designs no other one surpasses in both objectives.
void add_front_remark(const Ranking& ranking, std::vector<std::string>& remarks) {
  const std::vector<std::string> front = names_at(ranking, FrontPlace::front),
                                 open = names_at(ranking, FrontPlace::open);
  if (!ranking.objective.given() || front.empty()) return;
  constexpr std::size_t most = 8;
  std::string names;
  for (std::size_t k = 0; k < std::min(most, front.size()); ++k) names += (k > 0 ? ", " : "") + front[k];
  if (front.size() > most) names += " and " + std::to_string(front.size() - most) + " more";
  remarks.push_back(
      "Two objectives, " + ranked_quantity(ranking.rank_by) + " and the " +
      (ranking.objective.largest ? "largest " : "smallest ") +
      second_quantity(ranking, load_unit(ranking)).words + ": no design surpasses " + names +
      " in both (Pareto front)." +
      (open.empty()
           ? ""
           : " Whether " + std::to_string(open.size()) +
                 " more belong to the front is not known: the intervals of their differences are too wide."));
}

void add_lindqvist_remark(const Ranking& ranking, std::vector<std::string>& remarks) {
  if (!std::isfinite(ranking.spearman) || ranking.spearman_n < 4) return;
  const double rho = ranking.spearman;
  const char* order = rho >= 0.8   ? "much the same order"
                      : rho >= 0.4 ? "a partly similar order"
                      : rho > -0.4 ? "an order that has little to do with it"
                                   : "more nearly the opposite order";
  remarks.push_back("Lindqvist's formula puts the designs in " + std::string(order) +
                    " (Spearman's rank correlation " + fixed(rho, 2) + " over " +
                    std::to_string(ranking.spearman_n) + " designs).");
}

std::string unfinished(const StudyResults& study) {
  std::vector<std::string> parts;
  if (!study.running.empty())
    parts.push_back(counted(study.running.size(), "design") + " started without a result");
  if (!study.waiting.empty()) parts.push_back(counted(study.waiting.size(), "design") + " not started");
  if (study.proposals > 0)
    parts.push_back("up to " + std::to_string(study.proposals) + " more from the optimiser");
  const std::string missing = parts.empty() ? "" : ": " + listed(parts, 3);
  return (study.state == "interrupted" ? "The study was interrupted" : "The study is not finished") +
         missing + ". The ranking may change.";
}

void add_cautions(const StudyResults& study, int ranked, std::vector<std::string>& remarks) {
  std::map<std::string, std::vector<std::string>> designs;  // by the caution's words
  for (int i = 0; i < ranked; ++i) {
    const RankedDesign& row = study.ranking.rows[static_cast<std::size_t>(i)];
    const std::string caution = text_at(row.evaluation.result, result_key::lindqvist_caution);
    if (!caution.empty()) designs[caution].push_back(row.evaluation.name);
  }
  for (const auto& [caution, names] : designs)
    remarks.push_back("Lindqvist's formula for " + listed(names, 4) + ": " + sentence(caution));
}

void add_missing_remark(const StudyResults& study, std::vector<std::string>& remarks) {
  if (study.infeasible + study.failed_designs > 0) {
    std::vector<std::string> parts;
    if (study.infeasible > 0) parts.push_back(counted(study.infeasible, "design") + " infeasible");
    if (study.failed_designs > 0) parts.push_back(counted(study.failed_designs, "design") + " failed");
    remarks.push_back("Not ranked: " + listed(parts, 2) + ", each with its reason below.");
  }
  if (!study.finished()) remarks.push_back(unfinished(study));
}

}  // namespace

std::string value_in_words(const RankedDesign& row, const Ranking& ranking) {
  const LoadUnit unit = load_unit(ranking);
  const bool per_beam = ranking.rank_by == "mean_load_per_beam";
  const double newtons = per_beam ? 1e3 : unit.newtons;
  const double ci = value_ci95(row, ranking.rank_by) / newtons;
  if (!std::isfinite(ci) && !per_beam) return load_in_words(row.value, unit);
  const int decimals = decimals_for_interval(ci, per_beam || unit.name == "kN" ? 1 : 2, 3);
  return with_interval(row.value / newtons, ci, decimals) + "\u00a0" + (per_beam ? "kN/m" : unit.name);
}

std::string versus_in_words(const RankedDesign& row, const StudyResults& study) {
  const RankedDesign* other = baseline_of(study);
  std::string name = "the baseline";
  if (!other || other == &row) {
    other = &study.ranking.rows.front();
    name = other->evaluation.name;
  }
  if (other == &row || row.evaluation.name == other->evaluation.name) return {};
  const MeanDifference difference = compared_with(row, *other, study.ranking.rank_by);
  const std::string apart =
      apart_in_words(row.value, other->value, difference.ci95, name, load_unit(study.ranking));
  if (difference.ci95 == 0.0) return apart;  // without sampling error
  if (!std::isfinite(difference.ci95)) return apart + ", by means whose intervals are not known";
  return apart + " (" + p_in_words(difference.p) +
         (difference.p < told_apart_below ? ")" : ": not told apart)");
}

Verdict verdict(const StudyResults& study) {
  const int ranked = study.ranked();
  const TooShort records = too_short(study);
  const bool raced = study.ranking.race.given();
  Verdict result;
  result.ranks = ranked > 0 && (records.reason.empty() || raced);
  result.headline = result.ranks || ranked == 0 ? headline(study, ranked) : no_order(study, records);
  if (raced) result.remarks.push_back(race_in_words(study.ranking.race));
  if (level_is_open(study, ranked)) result.remarks.push_back(open_level(study));
  result.next = next_step(study, ranked, records);
  const Conditions found = conditions(study);
  if (!found.unlike_ships.empty()) result.remarks.push_back(found.unlike_ships);
  for (const std::string& words : study.ranking.disagreements) result.remarks.push_back(sentence(words));
  add_front_remark(study.ranking, result.remarks);
  if (study.ranking.rank_by != "lindqvist_breaking") add_lindqvist_remark(study.ranking, result.remarks);
  add_cautions(study, ranked, result.remarks);
  for (const std::string& warning : study.ranking.warnings)
    if (warning.rfind("not told apart", 0) != 0)  // the headline counts them, the table marks each
      result.remarks.push_back(sentence(warning));
  for (const auto* told : {&study.notes, &study.drifts, &study.lost_runs})
    for (const std::string& words : *told) result.remarks.push_back(sentence(words));
  add_missing_remark(study, result.remarks);
  return result;
}

std::string order_in_words(const StudyResults& study) {
  const TooShort records = too_short(study);
  if (study.ranked() == 0 || records.reason.empty() || study.ranking.race.given()) return {};
  return no_order(study, records) + ' ' + longer_records(records);
}

}  // namespace icebow
