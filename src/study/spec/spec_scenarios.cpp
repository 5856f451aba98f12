#include "study/spec/spec_scenarios.h"

#include <algorithm>
#include <memory>
#include <set>

#include "base/json_fields.h"
#include "study/spec/design_name.h"
#include "study/spec/spec_hints.h"
#include "study/spec/spec_section.h"

namespace icebow {
namespace {

constexpr std::size_t most_scenarios = 100;

bool is_condition(const std::string& section) {
  const std::vector<std::string>& all = condition_sections();
  return std::find(all.begin(), all.end(), section) != all.end();
}

void check_keys(const Json& entry, const std::string& at, Mistakes& mistakes) {
  const std::vector<std::string> keys = {"name", "weight", "set"};
  for (const auto& item : entry.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      mistakes.push_back(
          {at + "/" + item.key(),
           "is not a key of a scenario" + did_you_mean(item.key(), keys) + "; it has " + listed(keys)});
}

bool sets_conditions_only(const Json& set, const std::string& at, Mistakes& mistakes) {
  if (!set.is_object() || set.empty()) {
    mistakes.push_back(
        {at, "is " + shown(set) + ", must be an object like {\"ice\": {\"thickness_m\": 0.6}}"});
    return false;
  }
  bool good = true;
  for (const auto& item : set.items()) {
    if (is_condition(item.key())) {
      check_dropped_keys(item.key(), item.value(), at, mistakes);
      continue;
    }
    good = false;
    mistakes.push_back({at + "/" + item.key(),
                        "cannot be changed by a scenario, which may set " + listed(condition_sections()) +
                            did_you_mean(item.key(), condition_sections()) + "; the ship is the design's"});
  }
  return good;
}

CaseScenario read_scenario(const Json& document, const Json& entry, const std::string& at,
                           const CaseReader& reader, Mistakes& mistakes) {
  CaseScenario scenario;
  if (!entry.is_object()) {
    mistakes.push_back(
        {at, "is " + shown(entry) + ", must be {\"name\": \"...\", \"weight\": 1, \"set\": {...}}"});
    return scenario;
  }
  check_keys(entry, at, mistakes);
  scenario.name = text_at(entry, "/name");
  if (!is_design_name(scenario.name))
    mistakes.push_back({at + "/name", "is " + shown(entry.value("name", Json())) +
                                          ", must be 1 to 64 letters, digits, spaces or . _ + ( ) -"});
  const Json weight = entry.value("weight", Json(1.0));
  if (!weight.is_number() || !(weight.get<double>() > 0.0 && weight.get<double>() <= 1e6))
    mistakes.push_back({at + "/weight", "is " + shown(weight) + ", must be a number" +
                                            number_meant_by(weight) + ", allowed above 0 to 1e+06"});
  else
    scenario.weight = weight.get<double>();
  const Json set = entry.value("set", Json::object());
  if (!sets_conditions_only(set, at + "/set", mistakes)) return scenario;
  Json conditions = document;
  conditions.erase("scenarios");
  conditions.merge_patch(set);
  Mistakes theirs;
  scenario.given = std::make_shared<const Case>(reader(conditions, theirs));
  for (const Mistake& m : theirs) {
    const bool of_the_file = std::any_of(mistakes.begin(), mistakes.end(), [&](const Mistake& known) {
      return known.pointer == m.pointer && known.message == m.message;
    });
    if (!of_the_file) mistakes.push_back({at + "/set" + m.pointer, m.message});
  }
  return scenario;
}

}  // namespace

const std::vector<std::string>& condition_sections() {
  static const std::vector<std::string> sections = {"ice", "water", "operation"};
  return sections;
}

void read_scenarios(const Json& document, const CaseReader& reader, Case& c, Mistakes& mistakes) {
  if (!document.contains("scenarios")) return;
  const Json& list = document.at("scenarios");
  if (!list.is_array() || list.empty() || list.size() > most_scenarios) {
    mistakes.push_back(
        {"/scenarios", "is " + shown(list) + ", must be a list of 1 to " + std::to_string(most_scenarios) +
                           " [{\"name\": \"thin\", \"weight\": 0.7, \"set\": {\"ice\": {...}}}]"});
    return;
  }
  c.by_worst = text_at(document, "/ranking/over_scenarios") == "worst";
  std::set<std::string> names;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string at = "/scenarios/" + std::to_string(k);
    c.scenarios.push_back(read_scenario(document, list[k], at, reader, mistakes));
    const std::string& name = c.scenarios.back().name;
    if (!name.empty() && !names.insert(name).second)
      mistakes.push_back({at + "/name", "is \"" + name + "\", the name of an earlier scenario"});
  }
}

void check_scenarios(const StudySpec& spec, Mistakes& mistakes) {
  if (!spec.document.contains("scenarios")) {
    if (spec.document.contains(Json::json_pointer("/ranking/over_scenarios")))
      mistakes.push_back({"/ranking/over_scenarios", "is given, but the file has no /scenarios: drop it"});
    return;
  }
  for (const Variable& v : spec.method.variables)
    if (is_condition(v.pointer.substr(1, v.pointer.find('/', 1) - 1)))
      mistakes.push_back(
          {"/method/variables",
           "has " + v.pointer +
               ", which belongs to the conditions: where the file has /scenarios, those say what "
               "the conditions are; vary the ship, or give more scenarios"});
}

}  // namespace icebow
