#include "study/spec/spec_ranking.h"

#include <algorithm>

#include "base/json_fields.h"
#include "base/printable.h"
#include "study/spec/spec_constraints.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_method.h"

namespace icebow {
namespace {

const char* const example =
    "[\"mean_load\", {\"by\": \"/hydrostatics/displacement_kg\", \"best\": \"largest\"}]";

const std::vector<std::string>& quantities() {
  static const std::vector<std::string> known = {"mean_load", "mean_load_per_beam", "cycle_load",
                                                 "lindqvist_breaking"};
  return known;
}

std::string is_given(const std::string& by) {
  return "is \"" + shortened(printable(by), 40) + "\", ";
}

// A load of a result by its pointer; empty where it is one.
std::string fault_of_pointer(const StudySpec& spec, const std::string& by) {
  if (by.size() < 4 || by.compare(by.size() - 2, 2, "_N") != 0)
    return "a number that is no load: the keys of loads end in _N, in newtons at full scale";
  if (by.rfind("/scenarios/", 0) == 0) return "";
  if (by.rfind("/programs/", 0) != 0) return lacking_number(spec, by);
  const std::string name = by.substr(10, by.find('/', 10) - 10);
  std::vector<std::string> names;
  for (const ProgramEvaluator& program : spec.programs) names.push_back(program.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return "";
  return "which needs a program of the name \"" + name + "\" in /evaluators" + did_you_mean(name, names);
}

std::string fault_of_word(const StudySpec& spec, const std::string& by) {
  const std::vector<std::string>& known = quantities();
  if (std::find(known.begin(), known.end(), by) == known.end())
    return "must be one of " + listed(known) + did_you_mean(by, known) +
           ", or a pointer to a load of a result, like /programs/yard/resistance_N";
  const bool formula = by == "lindqvist_breaking", cycle = by == "cycle_load";
  if (formula ? spec.use_lindqvist : spec.use_cycle || (!cycle && spec.use_peridynamics)) return "";
  return std::string("which needs \"") +
         (formula ? "lindqvist\""
          : cycle ? "cycle\""
                  : "cycle\" or \"peridynamics\"") +
         " in /evaluators";
}

bool is_pointer(const std::string& by) {
  return !by.empty() && by[0] == '/';
}

// Where a word has its number.
std::string pointer_of(const std::string& by) {
  if (by == "lindqvist_breaking") return "/lindqvist/breaking_N";
  if (by == "cycle_load") return "/cycle/mean_load_N";
  return by == "mean_load" ? "/metrics/full_scale/mean_load_N" : by;
}

void check_second(const StudySpec& spec, const std::string& at, Mistakes& mistakes) {
  const std::string& by = spec.second.by;
  if (by.empty()) return;
  if (spec.method.type == MethodType::optimise && spec.method.algorithm == learning_algorithm)
    mistakes.push_back(
        {"/method/algorithm", std::string("is \"") + learning_algorithm +
                                  "\", which searches for one objective; with two take cobyla"});
  const std::string fault = is_pointer(by) ? lacking_number(spec, by) : fault_of_word(spec, by);
  if (!fault.empty()) mistakes.push_back({at, is_given(by) + fault});
  if (pointer_of(by) == pointer_of(spec.rank_by))
    mistakes.push_back({at, is_given(by) + "the first objective again; give another"});
}

// The second entry of a list of two.
SecondObjective parse_second(const Json& entry, Mistakes& mistakes) {
  const std::string at = "/ranking/by/1";
  SecondObjective second;
  if (entry.is_string()) {
    second.by = entry.get<std::string>();
    if (second.by.empty()) mistakes.push_back({at, "is empty, must be a word or a pointer"});
    return second;
  }
  const std::vector<std::string> keys = {"by", "best"};
  if (!entry.is_object()) {
    mistakes.push_back({at, "is " + shown(entry) +
                                ", must be a word, a pointer, or {\"by\": \"/hydrostatics/displacement_kg\", "
                                "\"best\": \"largest\"}"});
    return second;
  }
  for (const auto& item : entry.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      mistakes.push_back(
          {at + "/" + item.key(),
           "is not a key of an objective" + did_you_mean(item.key(), keys) + "; it has " + listed(keys)});
  second.by = text_at(entry, "/by");
  if (second.by.empty())
    mistakes.push_back({at + "/by", "is " + shown(entry.value("by", Json())) +
                                        ", must be a word like \"mean_load\" or a pointer to a number of a "
                                        "result"});
  const Json best = entry.value("best", Json("smallest"));
  if (best != "smallest" && best != "largest")
    mistakes.push_back({at + "/best", "is " + shown(best) + ", must be \"smallest\" or \"largest\""});
  second.largest = best == "largest";
  return second;
}

// The section as it is with one objective: the first. Notes what is wrong with a list.
Json with_first_objective(const Json& document, StudySpec& spec, Mistakes& mistakes) {
  Json one = Json::object();
  if (!document.contains("ranking")) return one;
  one["ranking"] = document.at("ranking");
  const Json by = part_at(one, "/ranking/by");
  if (!by.is_array()) return one;
  one["ranking"].erase("by");
  if (by.size() != 2 || !by[0].is_string()) {
    mistakes.push_back({"/ranking/by", "is " + shown(by) +
                                           ", must be a word, a pointer, or a list of two objectives, "
                                           "like " +
                                           example});
    return one;
  }
  one["ranking"]["by"] = by[0];
  spec.second = parse_second(by[1], mistakes);
  return one;
}

}  // namespace

void read_ranking(const Json& document, StudySpec& spec, bool evaluators_known, Mistakes& mistakes) {
  const std::size_t before = mistakes.size();
  const Json first = with_first_objective(document, spec, mistakes);
  const Section ranking(first, "ranking", 1.0, mistakes);
  spec.rank_by =
      ranking.text("by", spec.use_peridynamics || spec.use_cycle ? "mean_load" : "lindqvist_breaking");
  if (!ranking.good() || !evaluators_known || mistakes.size() > before) return;
  const bool two = spec.second.given();
  const std::string fault =
      is_pointer(spec.rank_by) ? fault_of_pointer(spec, spec.rank_by) : fault_of_word(spec, spec.rank_by);
  if (!fault.empty())
    mistakes.push_back({two ? "/ranking/by/0" : ranking.pointer("by"), is_given(spec.rank_by) + fault});
  check_second(spec, part_at(document, "/ranking/by/1").is_object() ? "/ranking/by/1/by" : "/ranking/by/1",
               mistakes);
}

Json to_json(const SecondObjective& second) {
  if (!second.given()) return nullptr;
  return {{"by", second.by}, {"best", second.largest ? "largest" : "smallest"}};
}

SecondObjective second_objective_from(const Json& json) {
  if (!json.is_object()) return {};
  return {text_at(json, "/by"), text_at(json, "/best") == "largest"};
}

}  // namespace icebow
