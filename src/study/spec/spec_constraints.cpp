#include "study/spec/spec_constraints.h"

#include <algorithm>
#include <cmath>

#include "base/json_fields.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

double bound(const Json& entry, const char* key, double none, const std::string& at, Mistakes& mistakes) {
  if (!entry.contains(key)) return none;
  const Json& value = entry.at(key);
  if (value.is_number()) return value.get<double>();
  mistakes.push_back({at + "/" + key, "is " + shown(value) + ", must be a number" +
                                          (value.is_string() ? number_meant(value.get<std::string>()) : "")});
  return none;
}

ResultConstraint parse_constraint(const Json& entry, const std::string& at, const StudySpec& spec,
                                  Mistakes& mistakes) {
  ResultConstraint c;
  const std::vector<std::string> keys = {"at", "min", "max"};
  if (!entry.is_object()) {
    mistakes.push_back(
        {at, "is " + shown(entry) +
                 ", must be an object like {\"at\": \"/hydrostatics/displacement_kg\", \"min\": 2e7}"});
    return c;
  }
  for (const auto& item : entry.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      mistakes.push_back(
          {at + "/" + item.key(),
           "is not a key of a constraint" + did_you_mean(item.key(), keys) + "; it has " + listed(keys)});
  c.at = text_at(entry, "/at");
  const std::string missing = lacking_number(spec, c.at);
  if (!missing.empty())
    mistakes.push_back({at + "/at", "is " + shown(entry.value("at", Json())) + ", " + missing});
  c.lower = bound(entry, "min", c.lower, at, mistakes);
  c.upper = bound(entry, "max", c.upper, at, mistakes);
  if (!entry.contains("min") && !entry.contains("max"))
    mistakes.push_back({at, "has neither min nor max; give one or both"});
  if (c.lower > c.upper)
    mistakes.push_back({at + "/min", "is " + brief(c.lower) + ", more than max " + brief(c.upper)});
  return c;
}

}  // namespace

std::string lacking_number(const StudySpec& spec, const std::string& at) {
  const auto below = [&](const std::string& part) {
    return at.size() > part.size() && at.rfind(part, 0) == 0;
  };
  if (below("/hull/margins/") || below("/hydrostatics/")) return "";
  if (below("/lindqvist/")) return spec.use_lindqvist ? "" : "needs \"lindqvist\" in /evaluators";
  if (below("/cycle/")) return spec.use_cycle ? "" : "needs \"cycle\" in /evaluators";
  if (below("/metrics/"))
    return spec.use_cycle || spec.use_peridynamics ? ""
                                                   : "needs \"cycle\" or \"peridynamics\" in /evaluators";
  for (const ProgramEvaluator& program : spec.programs)
    if (below("/programs/" + program.name + "/")) return "";
  if (below("/programs/")) return "needs a program of that name in /evaluators";
  return "must be the pointer of a number in a result, below /hull/margins, /hydrostatics, /lindqvist, "
         "/cycle, "
         "/metrics/full_scale or /programs/NAME";
}

void parse_constraints(const Json& document, StudySpec& spec, Mistakes& mistakes) {
  if (!document.contains("constraints")) return;
  const Json& list = document.at("constraints");
  if (!list.is_array() || list.empty()) {
    mistakes.push_back(
        {"/constraints", "is " + shown(list) +
                             ", must be a list of [{\"at\": \"/hydrostatics/displacement_kg\", "
                             "\"min\": 2e7, \"max\": 2.1e7}]"});
    return;
  }
  for (std::size_t k = 0; k < list.size(); ++k)
    spec.constraints.push_back(
        parse_constraint(list[k], "/constraints/" + std::to_string(k), spec, mistakes));
}

}  // namespace icebow
