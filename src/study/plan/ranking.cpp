#include "study/plan/ranking.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "base/json_fields.h"
#include "solver/model/statistics.h"
#include "study/evaluate/result_keys.h"
#include "study/plan/repeats.h"
#include "study/spec/spec_ranking.h"

namespace icebow {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double mean_load(const Json& result) {
  return number_at(result, result_key::mean_load);
}
double mean_load_ci95(const Json& result) {
  return number_at(result, result_key::mean_load_ci95);
}
double lindqvist_breaking(const Json& result) {
  return number_at(result, result_key::lindqvist_breaking);
}
double beam(const Json& result) {
  return number_at(result, result_key::beam);
}  //!< [m]

// A simulation says so; the cycle's load is whole where it has submersion.
bool is_whole_load(const Json& result) {
  const Json::json_pointer at(result_key::load_part);
  return result.contains(at) ? result.at(at) == "whole"
                             : number_at(result, result_key::cycle_submersion) > 0.0;
}

// Formulas, programs and what is read off a hull have no sampling error.
bool is_exact(const std::string& by) {
  return by == "lindqvist_breaking" || result_key::is_exact(by);
}

// Of a mean in a result the interval stands beside it: "mean_load_N", "mean_load_ci95_N".
double half_width_beside(const Json& result, const std::string& pointer) {
  const std::string unit = "_N";
  if (pointer.size() < unit.size() || pointer.compare(pointer.size() - unit.size(), unit.size(), unit) != 0)
    return nan_value;
  return number_at(result, pointer.substr(0, pointer.size() - unit.size()) + "_ci95" + unit);
}

// Half width of the interval of the ranked value; NaN = unknown.
double half_width(const RankedDesign& row, const std::string& rank_by) {
  if (is_exact(rank_by)) return 0.0;
  if (rank_by[0] == '/') return half_width_beside(row.evaluation.result, rank_by);
  if (rank_by == "cycle_load") return row.cycle_ci95;
  const double half = std::isfinite(row.difference_ci95) ? row.difference_ci95 : row.mean_load_ci95;
  return rank_by == "mean_load_per_beam" ? half / beam(row.evaluation.result) : half;
}

double cycle_samples(const Json& result) {
  const bool by_voyages =
      number_at(result, result_key::cycle_ci95_voyages) == number_at(result, result_key::cycle_load_ci95);
  return number_at(result, by_voyages ? result_key::cycle_voyages : result_key::cycle_effective_samples);
}

// Independent samples behind the half width; NaN = the result does not say.
double samples(const RankedDesign& row, const std::string& rank_by) {
  const Json& result = row.evaluation.result;
  if (rank_by[0] == '/')
    return result_key::is_of_cycle(rank_by) ? cycle_samples(result)
                                            : number_at(result, result_key::effective_samples);
  if (std::isfinite(row.difference_ci95) && rank_by != "cycle_load") return nan_value;
  if (rank_by != "cycle_load" && row.runs > 1) return row.runs;
  const bool swept = std::isfinite(row.cycle_load) && !part_at(result, result_key::simulation).is_object();
  return rank_by == "cycle_load" || swept ? cycle_samples(result)
                                          : number_at(result, result_key::effective_samples);
}

RankedDesign described(const std::vector<Evaluation>& runs, const std::string& rank_by) {
  const auto ok = std::find_if(runs.begin(), runs.end(),
                               [](const Evaluation& e) { return e.status == EvaluationStatus::ok; });
  RankedDesign row;
  row.evaluation = ok == runs.end() ? runs.front() : *ok;
  row.evaluation.name = run_name(row.evaluation.name).design;
  row.value = ranking_value(row.evaluation, rank_by);
  if (ok == runs.end()) return row;
  const Json& result = row.evaluation.result;
  std::vector<double> means, intervals;
  for (const Evaluation& e : runs) {
    if (e.status != EvaluationStatus::ok) continue;
    means.push_back(mean_load(e.result));
    intervals.push_back(mean_load_ci95(e.result));
  }
  const RepeatedMean all = repeated_mean(means, intervals);
  row.runs = std::max(1, all.runs);
  row.mean_load = all.mean;
  row.ci95_series = all.series;
  row.ci95_repeats = all.repeats;
  row.mean_load_ci95 = all.runs > 1 ? all.repeats : all.series;
  if (rank_by == "mean_load") row.value = row.mean_load;
  if (rank_by == "mean_load_per_beam") row.value = row.mean_load / beam(result);
  row.cycle_load = number_at(result, result_key::cycle_load);
  row.cycle_ci95 = number_at(result, result_key::cycle_load_ci95);
  row.same_way_load = number_at(result, result_key::cycle_same_way_load);
  row.same_way_ci95 = number_at(result, result_key::cycle_same_way_ci95);
  row.lindqvist_breaking = lindqvist_breaking(result);
  row.whole_load = is_whole_load(result);
  row.lindqvist = row.whole_load ? number_at(result, result_key::lindqvist_total) : row.lindqvist_breaking;
  if (row.lindqvist > 0.0) row.ratio = row.mean_load / row.lindqvist;
  if (!std::isfinite(row.value) && row.evaluation.reason.empty())
    row.evaluation.reason = "has no " + rank_by + " to rank by";
  return row;
}

// The runs of each design, designs as their first run comes.
std::vector<std::vector<Evaluation>> by_design(const std::vector<Evaluation>& evaluations) {
  std::vector<std::vector<Evaluation>> designs;
  std::map<std::string, std::size_t> place;
  for (const Evaluation& e : evaluations) {
    const auto [at, is_new] = place.emplace(run_name(e.name).design, designs.size());
    if (is_new) designs.emplace_back();
    designs[at->second].push_back(e);
  }
  for (std::vector<Evaluation>& runs : designs) {
    std::stable_sort(runs.begin(), runs.end(), [](const Evaluation& a, const Evaluation& b) {
      return run_name(a.name).number < run_name(b.name).number;
    });
  }
  return designs;
}

// Ranked, infeasible, failed (or without a value), running.
int group(const RankedDesign& row) {
  switch (row.evaluation.status) {
    case EvaluationStatus::ok:
      return std::isfinite(row.value) ? 0 : 2;
    case EvaluationStatus::infeasible:
      return 1;
    case EvaluationStatus::failed:
    case EvaluationStatus::damaged:
      return 2;
    case EvaluationStatus::running:
      return 3;
  }
  return 2;
}

bool before(const RankedDesign& a, const RankedDesign& b) {
  if (group(a) != group(b)) return group(a) < group(b);
  return group(a) == 0 && a.value < b.value;
}

void mark_ties(Ranking& ranking, std::size_t ranked) {
  const auto tied = [&](const RankedDesign& a, const RankedDesign& b) {
    return mean_difference(value_estimate(a, ranking.rank_by), value_estimate(b, ranking.rank_by)).p >=
           told_apart_below;
  };
  for (std::size_t i = 0; i < ranked; ++i) {
    RankedDesign& row = ranking.rows[i];
    row.rank = static_cast<int>(i) + 1;
    row.tied_with_next = i + 1 < ranked && tied(row, ranking.rows[i + 1]);
    row.tied_with_best = i > 0 && tied(row, ranking.rows[0]);
  }
}

// A number of the row by the words of a ranking: with all its runs, and corrected where it was confirmed.
double row_value(const RankedDesign& row, const std::string& by) {
  if (by == "mean_load") return row.mean_load;
  if (by == "mean_load_per_beam") return row.mean_load / beam(row.evaluation.result);
  return ranking_value(row.evaluation, by);
}

MeanEstimate estimate(const RankedDesign& row, const std::string& by, double value) {
  const double number = samples(row, by);
  return mean_estimate(value, half_width(row, by),
                       std::isfinite(number) ? number : std::numeric_limits<double>::infinity());
}

void find_front(Ranking& ranking, std::size_t ranked) {
  const SecondObjective& second = ranking.objective;
  if (!second.given()) return;
  std::vector<Objectives> objectives;
  for (std::size_t i = 0; i < ranked; ++i) {
    RankedDesign& row = ranking.rows[i];
    row.second = row_value(row, second.by), row.second_ci95 = half_width(row, second.by);
    objectives.push_back({value_estimate(row, ranking.rank_by),
                          estimate(row, second.by, second.largest ? -row.second : row.second)});
  }
  const std::vector<FrontPlace> places = front_places(objectives);
  for (std::size_t i = 0; i < ranked; ++i) ranking.rows[i].front = places[i];
}

// "baseline, d001, d002 and 4 more"
std::string listed_names(const std::vector<std::string>& names, std::size_t most = 5) {
  std::string text;
  for (std::size_t n = 0; n < std::min(names.size(), most); ++n) text += (n ? ", " : "") + names[n];
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

std::vector<std::string> warnings(const Ranking& ranking, std::size_t ranked) {
  std::vector<std::string> tied, biased, words;
  bool known = true;
  std::string sentence;
  for (std::size_t i = 0; i < ranked; ++i) {
    const RankedDesign& row = ranking.rows[i];
    const Json& result = row.evaluation.result;
    if (row.tied_with_best) tied.push_back(row.evaluation.name);
    const double bias = number_at(result, result_key::bias);
    const double spread = number_at(result, result_key::bias_ci95);
    if (!std::isfinite(bias)) {
      known = false;
      const Json::json_pointer at(result_key::bias_sentence);
      const bool said = result.is_structured() && result.contains(at) && result.at(at).is_string();
      if (sentence.empty() && said) sentence = result.at(at).get<std::string>();
    } else if (i > 0 && row.value - ranking.rows[0].value < (std::fabs(bias) + spread) * row.value) {
      biased.push_back(row.evaluation.name);
    }
  }
  if (!tied.empty())
    words.push_back("not told apart from the best design (Welch's test, p of 0.05 or more): " +
                    listed_names(tied) + "; a longer advance or more repeats narrow them");
  if (!known)
    words.push_back((sentence.empty() ? "resolution bias: not known for this spacing" : sentence) +
                    ". On a finer lattice, loads and their order may change by more than the intervals say");
  if (!biased.empty())
    words.push_back(
        "the difference to the best design is smaller than what the method's resolution may change: " +
        listed_names(biased));
  // Once for each ice.
  std::vector<std::string> ices;
  for (std::size_t i = 0; i < ranked; ++i) {
    const Json& result = ranking.rows[i].evaluation.result;
    const std::string words_of_ice = text_at(result, result_key::simulated_ice_sentence);
    if (words_of_ice.empty() || text_at(result, result_key::simulated_ice_model) != "paper") continue;
    if (std::find(ices.begin(), ices.end(), words_of_ice) == ices.end()) ices.push_back(words_of_ice);
  }
  words.insert(words.end(), ices.begin(), ices.end());
  return words;
}

void correlate(Ranking& ranking, std::size_t ranked) {
  std::vector<double> loads, formulas;
  for (std::size_t i = 0; i < ranked; ++i) {
    const RankedDesign& row = ranking.rows[i];
    if (!std::isfinite(row.mean_load) || !std::isfinite(row.lindqvist)) continue;
    loads.push_back(row.mean_load);
    formulas.push_back(row.lindqvist);
  }
  ranking.spearman = spearman_correlation(loads, formulas);
  ranking.spearman_n = static_cast<int>(loads.size());
}

Fidelities fidelities(const RankedDesign& row) {
  Fidelities f;
  f.design = row.evaluation.name, f.parameters = row.evaluation.parameters;
  f.cycle = row.cycle_load, f.cycle_ci95 = row.cycle_ci95;
  f.solver = row.solver_load, f.solver_ci95 = row.solver_ci95;
  f.beside = row.same_way_load, f.beside_ci95 = row.same_way_ci95;
  return f;
}

// Takes the simulations out of the rows and notes them with the designs they confirm.
void take_confirmations(Ranking& ranking) {
  std::map<std::string, RankedDesign> simulated;
  for (const RankedDesign& row : ranking.rows)
    if (is_confirmation(row.evaluation.name)) simulated[confirmed_design(row.evaluation.name)] = row;
  if (simulated.empty()) return;
  auto& rows = ranking.rows;
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const RankedDesign& row) { return is_confirmation(row.evaluation.name); }),
             rows.end());
  for (RankedDesign& row : rows) {
    const auto found = simulated.find(row.evaluation.name);
    if (found == simulated.end() || found->second.evaluation.status != EvaluationStatus::ok) continue;
    row.solver_load = found->second.mean_load, row.solver_ci95 = found->second.mean_load_ci95;
    row.same_way_load = found->second.same_way_load, row.same_way_ci95 = found->second.same_way_ci95;
    row.runs = found->second.runs;
  }
}

// The load of the cycle times the ratio of simulation and cycle, and the errors of both.
void correct(Ranking& ranking) {
  std::vector<Fidelities> all;
  for (const RankedDesign& row : ranking.rows)
    if (std::isfinite(row.cycle_load)) all.push_back(fidelities(row));
  ranking.confirmed = fit_ratio(all);
  if (ranking.confirmed.designs == 0) return;
  ranking.disagreements = disagreements(ranking.confirmed, all);
  for (RankedDesign& row : ranking.rows) {
    if (!std::isfinite(row.cycle_load)) continue;
    const auto& parameters = row.evaluation.parameters;
    row.mean_load = row.cycle_load * ranking.confirmed.ratio(parameters);
    row.mean_load_ci95 =
        row.mean_load * std::hypot(row.cycle_ci95 / row.cycle_load, ranking.confirmed.half_width(parameters));
    row.difference_ci95 = row.mean_load * std::hypot(row.cycle_ci95 / row.cycle_load,
                                                     ranking.confirmed.half_width_of_difference(parameters));
    if (ranking.rank_by == "mean_load") row.value = row.mean_load;
    if (ranking.rank_by == "mean_load_per_beam") row.value = row.mean_load / beam(row.evaluation.result);
    if (row.lindqvist > 0.0) row.ratio = row.mean_load / row.lindqvist;
  }
}

Json confirmed_json(const RatioFit& fit) {
  if (fit.designs == 0) return nullptr;
  return {{"designs", fit.designs},
          {"ratio", finite_or_null(std::exp(fit.constant))},
          {"ratio_ln_standard_error", finite_or_null(fit.constant_error)},
          {"between_designs_ln", finite_or_null(fit.between)},
          {"variable", fit.variable},
          {"slope_ln_per_unit", finite_or_null(fit.slope)},
          {"left_out_error_of_constant_ln", finite_or_null(fit.error_of_constant)},
          {"left_out_error_ln", finite_or_null(fit.error)}};
}

}  // namespace

double ranking_value(const Evaluation& e, const std::string& rank_by) {
  if (rank_by[0] == '/') return e.status == EvaluationStatus::ok ? number_at(e.result, rank_by) : nan_value;
  if (rank_by != "mean_load" && rank_by != "mean_load_per_beam" && rank_by != "cycle_load" &&
      rank_by != "lindqvist_breaking") {
    throw InputError("cannot rank by \"" + rank_by +
                     "\": allowed are mean_load, mean_load_per_beam, cycle_load, lindqvist_breaking");
  }
  if (e.status != EvaluationStatus::ok) return nan_value;
  if (rank_by == "mean_load") return mean_load(e.result);
  if (rank_by == "lindqvist_breaking") return lindqvist_breaking(e.result);
  if (rank_by == "cycle_load") return number_at(e.result, result_key::cycle_load);
  return mean_load(e.result) / beam(e.result);
}

MeanEstimate value_estimate(const RankedDesign& row, const std::string& rank_by) {
  return estimate(row, rank_by, row.value);
}

Ranking rank_designs(const std::vector<Evaluation>& evaluations, const std::string& rank_by,
                     const SecondObjective& second) {
  Ranking ranking;
  ranking.rank_by = rank_by, ranking.objective = second;
  for (const std::vector<Evaluation>& runs : by_design(evaluations))
    ranking.rows.push_back(described(runs, rank_by));
  take_confirmations(ranking);
  correct(ranking);
  std::stable_sort(ranking.rows.begin(), ranking.rows.end(), before);
  const auto ranked = static_cast<std::size_t>(std::count_if(
      ranking.rows.begin(), ranking.rows.end(), [](const RankedDesign& row) { return group(row) == 0; }));
  mark_ties(ranking, ranked);
  find_front(ranking, ranked);
  correlate(ranking, ranked);
  if (ranked > 0 && !is_exact(rank_by)) ranking.warnings = warnings(ranking, ranked);
  return ranking;
}

std::vector<std::string> designs_to_confirm(const std::vector<Evaluation>& evaluations,
                                            const StudySpec& spec) {
  std::vector<Evaluation> swept;
  for (const Evaluation& e : evaluations)
    if (!is_confirmation(e.name)) swept.push_back(e);
  const Ranking ranking = rank_designs(swept, spec.rank_by);
  std::vector<Fidelities> ranked;
  for (const RankedDesign& row : ranking.rows)
    if (row.rank > 0 && std::isfinite(row.cycle_load)) ranked.push_back(fidelities(row));
  return designs_to_confirm(ranked, spec.confirm.best, spec.confirm.spread);
}

Json to_json(const Ranking& ranking) {
  Json designs = Json::array();
  for (const RankedDesign& row : ranking.rows) {
    const Evaluation& e = row.evaluation;
    designs.push_back({{"design", e.name},
                       {"status", to_string(e.status)},
                       {"reason", e.reason},
                       {"parameters", parameters_json(e.parameters)},
                       {"mean_load_N", finite_or_null(row.mean_load)},
                       {"mean_load_ci95_N", finite_or_null(row.mean_load_ci95)},
                       {"runs", row.runs},
                       {"ci95_series_N", finite_or_null(row.ci95_series)},
                       {"ci95_repeats_N", finite_or_null(row.ci95_repeats)},
                       {"cycle_load_N", finite_or_null(row.cycle_load)},
                       {"cycle_load_ci95_N", finite_or_null(row.cycle_ci95)},
                       {"solver_load_N", finite_or_null(row.solver_load)},
                       {"solver_load_ci95_N", finite_or_null(row.solver_ci95)},
                       {"lindqvist_breaking_N", finite_or_null(row.lindqvist_breaking)},
                       {"lindqvist_N", finite_or_null(row.lindqvist)},
                       {"lindqvist_part", row.whole_load ? "total" : "breaking"},
                       {"ratio", finite_or_null(row.ratio)},
                       {"rank", row.rank},
                       {"tied_with_next", row.tied_with_next},
                       {"tied_with_best", row.tied_with_best}});
    if (!ranking.objective.given()) continue;
    designs.back()["second"] = finite_or_null(row.second);
    designs.back()["second_ci95"] = finite_or_null(row.second_ci95);
    designs.back()["front"] = row.front == FrontPlace::none ? Json(nullptr) : Json(to_string(row.front));
  }
  Json json = {{"rank_by", ranking.rank_by},
               {"designs", designs},
               {"race", to_json(ranking.race)},
               {"warnings", ranking.warnings},
               {"disagreements", ranking.disagreements},
               {"confirmed", confirmed_json(ranking.confirmed)},
               {"spearman", finite_or_null(ranking.spearman)},
               {"spearman_n", ranking.spearman_n}};
  if (ranking.objective.given()) json["second"] = to_json(ranking.objective);
  return json;
}

std::vector<std::string> names_at(const Ranking& ranking, FrontPlace place) {
  std::vector<std::string> names;
  for (const RankedDesign& row : ranking.rows)
    if (row.rank > 0 && row.front == place) names.push_back(row.evaluation.name);
  return names;
}

std::string front_in_words(const Ranking& ranking) {
  if (!ranking.objective.given()) return "";
  constexpr std::size_t most = 12;
  const std::vector<std::string> front = names_at(ranking, FrontPlace::front),
                                 open = names_at(ranking, FrontPlace::open);
  if (front.empty()) return "no design has both " + ranking.rank_by + " and " + ranking.objective.by;
  std::string words = "no design is better in both " + ranking.rank_by + " and " + ranking.objective.by +
                      " (" + (ranking.objective.largest ? "largest" : "smallest") +
                      " is best) than: " + listed_names(front, most);
  if (!open.empty())
    words += "; nor surely, within the intervals of their differences, than: " + listed_names(open, most);
  return words;
}

const RankedDesign* best_of(const Ranking& ranking) {
  for (const RankedDesign& row : ranking.rows)
    if (row.rank > 0 && ranking.race.given() && row.evaluation.name == ranking.race.legs.back().leader)
      return &row;
  return !ranking.rows.empty() && ranking.rows.front().rank == 1 ? &ranking.rows.front() : nullptr;
}

std::string compared_part(const Ranking& ranking) {
  bool whole = false, part = false;
  for (const RankedDesign& row : ranking.rows) {
    if (row.rank > 0) (row.whole_load ? whole : part) = true;
  }
  return whole && part ? "total or breaking" : whole ? "total" : "breaking";
}

}  // namespace icebow
