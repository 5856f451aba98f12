#include "study/spec/read_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "base/errors.h"
#include "study/spec/held_document.h"
#include "study/spec/spec_case.h"
#include "study/spec/spec_constraints.h"
#include "study/spec/spec_designs.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_hull.h"
#include "study/spec/spec_method.h"
#include "study/spec/spec_ranking.h"
#include "study/spec/spec_scenarios.h"
#include "study/spec/spec_table.h"

namespace icebow {
namespace {

void check_repeats(const StudySpec& spec, Mistakes& mistakes) {
  if (spec.repeats <= 1 || spec.use_peridynamics || spec.confirm.given()) return;
  mistakes.push_back(
      {"/repeats", "is " + std::to_string(spec.repeats) +
                       ", but without \"peridynamics\" in /evaluators each time gives the "
                       "same: drop it, or add \"peridynamics\"; the cycle has /cycle/voyages"});
}

// With "confirm" the sweep is the cycle's, and the simulation of what is confirmed is understood.
void read_confirm(const Json& document, StudySpec& spec, bool evaluators_known, Mistakes& mistakes) {
  const Section confirm(document, "confirm", 1.0, mistakes);
  if (!document.contains("confirm")) return;
  spec.confirm = {confirm.integer("best"), confirm.integer("spread")};
  if (confirm.good() && !spec.confirm.given())
    mistakes.push_back(
        {"/confirm", "confirms no design: \"best\" and \"spread\" are 0; drop it, or give one"});
  if (evaluators_known && !spec.use_cycle)
    mistakes.push_back(
        {"/confirm", "needs \"cycle\" in /evaluators: the simulation confirms designs of the cycle"});
  spec.use_peridynamics = false;
}

// Longer voyages instead of repeated ones, so each design is one voyage in a window that can sail on.
void check_decide(const StudySpec& spec, Mistakes& mistakes) {
  const auto mistake = [&](const char* at, const std::string& words) { mistakes.push_back({at, words}); };
  if (spec.confirm.given())
    mistake("/decide", "is given beside /confirm, whose ranking goes by the cycle: drop one of them");
  else if (!spec.use_peridynamics)
    mistake(
        "/decide",
        "needs \"peridynamics\" in /evaluators, whose voyages are sailed on; the cycle has /cycle/voyages");
  if (spec.method.type == MethodType::optimise)
    mistake("/decide",
            "decides between designs that are known, not optimise, which proposes as it goes: take a method "
            "like grid or latin_hypercube");
  if (spec.second.given())
    mistake("/ranking/by", "gives two objectives, but /decide decides by one load: drop one of them");
  if (spec.repeats > 1)
    mistake("/repeats", "is " + std::to_string(spec.repeats) +
                            ", but with /decide each design is one voyage that is sailed on: drop it");
  if (spec.rank_by != "mean_load" && spec.rank_by != "mean_load_per_beam")
    mistake("/ranking/by", "is \"" + spec.rank_by +
                               "\", but /decide decides by \"mean_load\" or "
                               "\"mean_load_per_beam\"");
  if (!spec.baseline.scenarios.empty())
    mistake("/decide", "sails on one voyage of each design, but /scenarios give several: drop one of them");
  if (spec.baseline.stop_when_ci95_below > 0.0)
    mistake("/operation/stop_when_ci95_below",
            "ends each run by itself, but with /decide the race says how far each sails: drop it");
  if (spec.decide.longest > 0.0 && spec.decide.longest < spec.baseline.advance)
    mistake("/decide/longest_m", "is " + brief(spec.decide.longest) + " m, less than the first leg of " +
                                     brief(spec.baseline.advance) +
                                     " m: give that of /operation/advance or more, or shorten the advance");
  if (!(spec.baseline.sheet.window_ahead > 0.0))
    mistake("/decide",
            "needs a window that moves with the ship, so that a voyage can be sailed on: give "
            "/sheet/window_ahead_m, two characteristic lengths or more, like 40");
}

void read_decide(const Json& document, StudySpec& spec, bool all_known, Mistakes& mistakes) {
  const Section decide(document, "decide", 1.0, mistakes);
  if (!document.contains("decide")) return;
  const double longest = decide.number("longest");
  spec.decide = {decide.number("best_within"), decide.number("confidence"), decide.number("budget_core_h"),
                 std::isnan(longest) ? 0.0 : longest, true};
  if (all_known) check_decide(spec, mistakes);
}

void check_not_empty(const StudySpec& spec, Mistakes& mistakes) {
  if (spec.include_baseline || !spec.designs.empty() || spec.method.type != MethodType::list) return;
  mistakes.push_back(
      {"/include_baseline", "is false, and neither designs nor a method give any other design"});
}

// Every part of the document is read whatever the others hold, so that one look shows all that is wrong.
std::vector<std::string> launcher_words(const std::string& launcher) {
  std::istringstream stream(launcher);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

void check_launcher(const Section& section, const Execution& execution, Mistakes& mistakes) {
  const std::vector<std::string>& words = execution.launcher;
  if (words.empty() || execution.ranks_per_design <= 1) return;
  const bool told = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.find("{ranks}") != std::string::npos;
  });
  if (!told)
    mistakes.push_back({section.pointer("launcher"),
                        "does not say how many ranks a design has: write {ranks} where "
                        "the number belongs, like \"srun --exact -n {ranks}\""});
}

StudySpec parse_study(const Json& document, const std::string& name, Mistakes& mistakes) {
  StudySpec spec;
  spec.file = name;
  spec.document = document;
  std::vector<std::string> elsewhere = structural_keys();
  Json top = document;
  top.erase("scale");  // read with the case
  const Section main(top, "", 1.0, mistakes, elsewhere);
  spec.name = main.text("name", std::filesystem::path(name).stem().string());
  spec.purpose = main.text("purpose", "");
  spec.include_baseline = main.boolean("include_baseline");
  spec.repeats = std::max(1, main.integer("repeats"));
  spec.baseline = parse_case(document, mistakes);
  const std::size_t before = mistakes.size();
  parse_evaluators(document, spec, mistakes);
  const bool evaluators_known = mistakes.size() == before;
  read_confirm(document, spec, evaluators_known, mistakes);
  spec.designs = parse_designs(document, mistakes);
  spec.method = parse_method(document, mistakes);
  read_ranking(document, spec, evaluators_known, mistakes);
  const Section execution(document, "execution", 1.0, mistakes);
  spec.execution = {execution.integer("ranks_per_design"), execution.integer("designs_at_once"),
                    execution.number("time_limit"), execution.number("stop_at_failure_rate"),
                    launcher_words(execution.text("launcher", ""))};
  check_launcher(execution, spec.execution, mistakes);
  if (evaluators_known) check_repeats(spec, mistakes);
  if (evaluators_known) check_scenarios(spec, mistakes);
  if (evaluators_known) parse_constraints(document, spec, mistakes);
  read_decide(document, spec, mistakes.empty(), mistakes);
  check_not_empty(spec, mistakes);
  return spec;
}

}  // namespace

StudySpec read_study(const Json& document, const std::string& name) {
  Mistakes mistakes;
  if (!document.is_object()) {
    throw InputError(name,
                     {{"", "is " + type_name(document) + ", must be an object {\"icebow_study\": 1, ...}"}});
  }
  Json resolved = document;
  resolve_hull_files(resolved, name);
  resolve_program_files(resolved, name);
  take_in_table(resolved, name);
  hold_displacement(resolved);
  StudySpec spec = parse_study(resolved, name, mistakes);
  if (!mistakes.empty()) throw InputError(name, std::move(mistakes));
  return spec;
}

StudySpec read_study(const std::string& path) {
  return read_study(read_json_file(path), path);
}

void apply_set(Json& document, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || assignment.empty() || assignment[0] != '/') {
    throw InputError("--set " + assignment + ": must be /section/key=value, like /bow/stem_deg=20");
  }
  const std::string pointer = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  Json value;
  try {
    value = parse_json(text, "--set " + assignment);
  } catch (const InputError&) {
    value = text;
  }
  try {
    document[Json::json_pointer(pointer)] = value;
  } catch (const Json::exception&) {
    throw InputError("--set " + assignment + ": " + pointer +
                     " is no place in the study file, whose keys look like /bow/stem_deg");
  }
}

}  // namespace icebow
