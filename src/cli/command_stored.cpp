// `icebow status`, `watch`, `show`, `export`, `diff` and `effects`: a study directory read again.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>
#include <tuple>

#include "base/errors.h"
#include "base/json_fields.h"
#include "base/json_words.h"
#include "base/stop_signal.h"
#include "cli/commands.h"
#include "cli/number_option.h"
#include "cli/text_table.h"
#include "study/effects/effects_json.h"
#include "study/evaluate/evaluation.h"
#include "study/evaluate/result_keys.h"
#include "study/evaluate/scenario_result.h"
#include "study/look/design_card.h"
#include "study/look/stored_design.h"
#include "study/look/study_diff.h"
#include "study/look/study_status.h"
#include "study/look/study_table.h"
#include "study/spec/document_keys.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hold.h"

namespace icebow {
namespace {

int print_json(const Json& json) {
  std::cout << json_text(json, 2) << "\n";
  return exit_code::ok;
}

std::string words(const Json& json, const char* key) {
  return json.at(key).is_string() ? json.at(key).get<std::string>() : "";
}

std::string newtons(const Json& value) {
  return value.is_number() ? decimals(value.get<double>() / 1e3, 1) + " kN" : "-";
}

std::string list_text(const Json& names) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k)
    text += (k ? ", " : "") + names[k].get<std::string>();
  return text + (names.size() > most ? " and " + std::to_string(names.size() - most) + " more" : "");
}

std::string status_text(const Json& s) {
  const auto count = [&](const char* key) { return std::to_string(s.at(key).get<int>()); };
  const auto words = [&](const char* key) { return text_at(s, std::string("/") + key); };
  std::string text = words("name") + ": " + words("state") + "\n" + count("designs") + " designs";
  if (s.at("may_follow") > 0) text += ", at most " + count("may_follow") + " more";
  text += ": " + count("ok") + " ok, " + count("infeasible") + " infeasible, " + count("failed") + " failed";
  if (s.at("damaged") > 0) text += ", " + count("damaged") + " damaged";
  text += "\n";
  for (const Json& name : s.at("running")) text += "under way: " + name.get<std::string>() + "\n";
  const std::string over =
      s.contains("scenarios") ? ", the " + words("over_scenarios") + " of its scenarios" : "";
  if (s.at("best").is_string())
    text += "best so far by " + words("rank_by") + over + ": " + words("best") + ", " +
            newtons(s.at("value")) + "\n";
  if (s.contains("scenarios"))
    for (const Json& one : s.at("scenarios"))
      text += "  " + text_at(one, result_key::scenario_name) + ": " + newtons(one.at("mean_load_N")) + "\n";
  if (s.contains("front")) text += "Pareto front so far: " + list_text(s.at("front")) + "\n";
  return text + "started " + words("started") + " on " + words("host") + " by icebow " + words("version") +
         "\n  " + words("command") + "\n";
}

constexpr const char* no_interval = nullptr;

// A load with its interval, where the result has it.
std::vector<std::string> load_row(const Json& result, const char* name, const char* load, const char* ci95) {
  const double value = number_at(result, load), half = ci95 ? number_at(result, ci95) : NAN;
  return {name, decimals(value / 1e3, 1) + (std::isfinite(half) ? " \u00b1 " + decimals(half / 1e3, 1) : "") +
                    " kN"};
}

std::string results_text(const Json& result) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, load, ci95] :
       {std::tuple("mean load", result_key::mean_load, result_key::mean_load_ci95),
        std::tuple("by the cycle", result_key::cycle_load, result_key::cycle_load_ci95),
        std::tuple("Lindqvist, breaking", result_key::lindqvist_breaking, no_interval),
        std::tuple("Lindqvist, total", result_key::lindqvist_total, no_interval),
        std::tuple("largest load", result_key::max_load, no_interval)})
    if (std::isfinite(number_at(result, load))) rows.push_back(load_row(result, name, load, ci95));
  for (const ScenarioLoad& load : scenario_loads(result))
    rows.push_back({"scenario " + load.name,
                    decimals(load.mean / 1e3, 1) +
                        (std::isfinite(load.ci95) ? " \u00b1 " + decimals(load.ci95 / 1e3, 1) : "") + " kN"});
  return rows.empty() ? "" : "\n" + text_table(rows);
}

std::string place_in_words(const std::string& front) {
  if (front == "front") return "on the Pareto front";
  if (front == "open") return "not on the Pareto front, but not surely off it";
  return front == "dominated" ? "surely off the Pareto front" : "without a place at the Pareto front";
}

std::string card_text(const Json& card) {
  std::string text = words(card, "design") + ": " + words(card, "status");
  if (!words(card, "reason").empty()) text += ": " + words(card, "reason");
  if (card.at("rank") > 0)
    text += ", rank " + std::to_string(card.at("rank").get<int>()) + " of " +
            std::to_string(card.at("designs").get<int>()) + " by " + words(card, "rank_by") + ", " +
            newtons(card.at("value"));
  text += "\n";
  if (card.contains("front"))
    text += "second objective " + text_at(card, "/second/by") + ": " +
            brief(number_at(card, "/second/value")) + ", " + place_in_words(words(card, "front")) + "\n";
  for (const Json& note : card.at("notes")) text += "note: " + note.get<std::string>() + "\n";
  for (const auto& [pointer, word] : words_at(card.at("result"), result_key::choices))
    text += "  " + pointer + " " + word + "\n";
  for (const auto& [pointer, value] : card.at("parameters").items())
    text += "  " + pointer + " " + (value.is_number() ? brief(value.get<double>()) : "-") + "\n";
  const Json& result = card.at("result");
  text += results_text(result);
  const std::string date = text_at(result, result_key::evaluated_at);
  if (!date.empty())
    text += "\nevaluated " + date + " on " + text_at(result, result_key::evaluated_on) + " by icebow " +
            text_at(result, result_key::evaluated_by) + " in " +
            clock_time(number_at(result, result_key::evaluation_seconds)) + "\n";
  if (card.at("directory").is_string()) text += "files: " + words(card, "directory") + "\n";
  if (!card.at("commands").is_object()) return text;
  text += "again: " + words(card.at("commands"), "again") + "\n";
  const std::string finer = words(card.at("commands"), "finer");
  return text +
         "finer: " + (finer.empty() ? "the lattice is as fine as the ice's virtual tests reach" : finer) +
         "\n";
}

std::string value_text(const Json& value) {
  return value.is_null() ? "-" : value.is_number() ? brief(value.get<double>()) : value.dump();
}

std::string names_text(const std::string& label, const Json& names) {
  return names.empty() ? "" : label + ": " + list_text(names) + "\n";
}

std::string diff_text(const Json& diff, const Arguments& arguments) {
  std::vector<std::vector<std::string>> asked = {{"study file", arguments.positional, arguments.second}},
                                        designs = {
                                            {"design", "rank", "value", "other", "rank", "value", "ratio"}};
  for (const Json& d : diff.at("study"))
    asked.push_back({words(d, "at"), value_text(d.at("first")), value_text(d.at("second"))});
  for (const Json& d : diff.at("designs")) {
    const Json &a = d.at("first"), &b = d.at("second");
    designs.push_back({words(a, "design"), value_text(a.at("rank")), value_text(a.at("value")),
                       words(b, "design"), value_text(b.at("rank")), value_text(b.at("value")),
                       d.at("ratio").is_number() ? decimals(d.at("ratio").get<double>(), 4) : "-"});
  }
  std::string text = asked.size() > 1 ? text_table(asked) + "\n" : "the same was asked of both\n\n";
  const Json& by = diff.at("rank_by");
  if (by[0] != by[1])
    text += "ranked by unlike numbers, " + by[0].get<std::string>() + " and " + by[1].get<std::string>() +
            ": their values have no ratio\n\n";
  text += designs.size() > 1 ? text_table(designs) : "no design is in both\n";
  return text + names_text("only in " + arguments.positional, diff.at("only_first")) +
         names_text("only in " + arguments.second, diff.at("only_second"));
}

// `icebow watch`: the status of a study that another terminal runs, again and again.
constexpr double shortest = 0.1, usual = 2.0, longest = 3600.0;  //!< between two looks [s]

double interval(const Arguments& arguments) {
  return number_option(arguments, "--seconds", usual, shortest, longest, "s");
}

// False where a signal came meanwhile.
bool sleep_for(double seconds) {
  constexpr auto moment = std::chrono::milliseconds(50);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    if (StopSignal::raised()) return false;
    std::this_thread::sleep_for(moment);
  }
  return !StopSignal::raised();
}

// One look takes the place of the one before on a terminal; elsewhere it follows, where something has
// changed.
class Window {
 public:
  Window() : terminal_(::isatty(STDOUT_FILENO) != 0) {}
  void show(const std::string& text) {
    if (text == shown_) return;
    if (terminal_ && !shown_.empty())
      std::cout << "\033[" << std::count(shown_.begin(), shown_.end(), '\n') << "A\033[J";
    else if (!shown_.empty())
      std::cout << "\n";
    std::cout << text << std::flush;
    shown_ = text;
  }

 private:
  bool terminal_;
  std::string shown_;
};

std::string share_text(const Share& share) {
  return decimals(share.value, 2) + " (" + decimals(share.low, 2) + " to " + decimals(share.high, 2) + ")";
}

std::string effects_text(const ResponseFit& fit, const std::string& rank_by) {
  std::string text = "response of " + rank_by + ": " + fit_in_words(fit) + "\n";
  if (!fit.told()) return text;
  std::vector<std::vector<std::string>> rows = {{"parameter", "from", "to", "change, kN", "told from none"}};
  if (fit.has_sobol) rows[0].insert(rows[0].end(), {"Sobol', by itself", "Sobol', in all"});
  for (const Effect& e : fit.effects) {
    rows.push_back({e.pointer, brief(e.lower), brief(e.upper),
                    decimals(e.change / 1e3, 1) + " \u00b1 " + decimals(e.ci95 / 1e3, 1),
                    e.told() ? "yes" : "no"});
    if (fit.has_sobol)
      rows.back().insert(rows.back().end(), {share_text(e.sobol.first), share_text(e.sobol.total)});
  }
  return text + "\nchange over the whole range, the other parameters in the middle, \u00b1 95 % interval" +
         (fit.has_sobol ? "; Sobol' indices: share of the fitted variance over the box, with 95 % interval"
                        : "") +
         "\n\n" + text_table(rows);
}

std::string elementary_text(const std::vector<ElementaryEffects>& effects) {
  if (effects.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"parameter", "steps", "mean size, kN", "mean, kN", "deviation, kN"}};
  for (const ElementaryEffects& e : effects)
    rows.push_back({e.pointer, std::to_string(e.steps),
                    decimals(e.mean_size / 1e3, 1) + " \u00b1 " + decimals(e.mean_size_ci95 / 1e3, 1),
                    decimals(e.mean / 1e3, 1), decimals(e.deviation / 1e3, 1)});
  return "\nelementary effects (Morris): steps of one parameter, as changes over its whole range\n\n" +
         text_table(rows);
}

}  // namespace

int run_status(const Communicator&, const Arguments& arguments) {
  const Json status = study_status(arguments.positional);
  if (arguments.has("--json")) return print_json(status);
  std::cout << status_text(status);
  return exit_code::ok;
}

int run_watch(const Communicator&, const Arguments& arguments) {
  const double seconds = interval(arguments);
  const StopSignal signals;
  Window window;
  for (;;) {
    const Json status = study_status(arguments.positional);
    window.show(status_text(status));
    if (arguments.has("--once") || status.at("state") != "running" || !sleep_for(seconds))
      return exit_code::ok;
  }
}

int run_show(const Communicator&, const Arguments& arguments) {
  const Json card = design_card(arguments.positional, arguments.second);
  if (arguments.has("--json")) return print_json(card);
  std::cout << card_text(card);
  return exit_code::ok;
}

int run_export(const Communicator&, const Arguments& arguments) {
  if (arguments.has("--json") + arguments.has("--csv") + arguments.has("--hdf5") > 1)
    throw InputError("icebow export: --csv, --json and --hdf5 are different files; keep one of them");
  const Json table = study_table(arguments.positional);
  if (arguments.has("--hdf5")) {
    write_study_hdf5(table, arguments.value("--hdf5"));
    std::cout << arguments.value("--hdf5") << "\n";
    return exit_code::ok;
  }
  if (arguments.has("--json")) return print_json(table);
  std::cout << study_csv(table);
  return exit_code::ok;
}

int run_diff(const Communicator&, const Arguments& arguments) {
  const Json diff = study_diff(arguments.positional, arguments.second);
  if (arguments.has("--json")) return print_json(diff);
  std::cout << diff_text(diff, arguments);
  return exit_code::ok;
}

int run_effects(const Communicator&, const Arguments& arguments) {
  const Store store = open_store_of(arguments.positional);
  const Ranking ranking = stored_ranking(store);
  const ResponseFit fit = fit_response(ranking, held_pointer(document_of(store)));
  const bool is_morris = text_at(document_of(store), document_key::method_type) == "morris";
  const std::vector<ElementaryEffects> steps =
      is_morris ? elementary_effects(ranking) : std::vector<ElementaryEffects>();
  if (arguments.has("--json")) {
    Json json = effects_json(fit, ranking.rank_by);
    if (is_morris) json["elementary"] = elementary_json(steps);
    return print_json(json);
  }
  std::cout << effects_text(fit, ranking.rank_by) << elementary_text(steps);
  return exit_code::ok;
}

}  // namespace icebow
