#include "study/spec/spec_constraints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/json_fields.h"
#include "study/spec/spec_hints.h"

namespace icebow {
namespace {

const std::string process_of_cycle = "/cycle/process/";  // too many to be listed

// As study/evaluate/result_json.h writes them.
const std::vector<std::string> metrics = {"mean_load_N",
                                          "mean_load_ci95_N",
                                          "max_load_N",
                                          "q95_load_N",
                                          "std_load_N",
                                          "vertical_mean_N",
                                          "vertical_max_N",
                                          "vertical_mean_ci95_N",
                                          "channel_width_m",
                                          "broken_volume_m3",
                                          "crushed_volume_m3",
                                          "steady_from_m",
                                          "steady_to_m",
                                          "samples",
                                          "effective_samples",
                                          "drift/relative",
                                          "drift/p",
                                          "broken_bonds",
                                          "bonds",
                                          "mean_damage",
                                          "floes",
                                          "channel_width_over_beam",
                                          "lambda",
                                          "resolution_bias/relative",
                                          "resolution_bias/ci95"};
constexpr std::size_t at_full_scale = 13;  // of these, the first ones
const std::vector<std::string> hydrostatics = {"displacement_kg",
                                               "volume_m3",
                                               "wetted_area_m2",
                                               "waterplane_area_m2",
                                               "block_coefficient",
                                               "waterplane_coefficient",
                                               "draft_m",
                                               "length_m",
                                               "beam_m",
                                               "KB_m",
                                               "LCB_m",
                                               "TCB_m",
                                               "LCF_m",
                                               "I_T_m4",
                                               "I_L_m4",
                                               "BM_T_m",
                                               "BM_L_m",
                                               "KM_T_m"};
const std::vector<std::string> lindqvist = {
    "breaking_N", "total_N",      "crushing_N",        "bending_N",       "submersion_N",
    "inputs/L_m", "inputs/B_m",   "inputs/T_m",        "inputs/stem_deg", "inputs/waterline_deg",
    "inputs/h_m", "inputs/V_m_s", "inputs/sigma_f_Pa", "inputs/E_Pa",     "inputs/nu",
    "inputs/mu",  "inputs/rho_i", "inputs/rho_w",      "inputs/g"};
const std::vector<std::string> cycle = {"mean_load_N",
                                        "mean_load_ci95_N",
                                        "ci95_series_N",
                                        "ci95_voyages_N",
                                        "crushing_N",
                                        "bending_N",
                                        "friction_N",
                                        "submersion_N",
                                        "water_N",
                                        "breaking_length_m",
                                        "breaking_length_over_characteristic",
                                        "contact_width_m",
                                        "channel_width_m",
                                        "submersion_depth_m",
                                        "under_bottom_share",
                                        "pieces",
                                        "voyages",
                                        "voyage_m",
                                        "wall_s",
                                        "same_way/mean_load_N",
                                        "same_way/ci95_N",
                                        "same_way/from_m",
                                        "same_way/to_m"};
const std::vector<std::string> margins = {"g1", "g2", "g3", "g4", "g5", "g6", "g7", "g8", "g9", "g10"};

std::vector<std::string> all_numbers() {
  std::vector<std::string> all;
  const auto add = [&](const std::string& part, const std::vector<std::string>& names, std::size_t first) {
    for (std::size_t k = 0; k < std::min(first, names.size()); ++k) all.push_back(part + names[k]);
  };
  add("/hull/margins/", margins, margins.size());
  add("/hydrostatics/", hydrostatics, hydrostatics.size());
  add("/lindqvist/", lindqvist, lindqvist.size());
  add("/cycle/", cycle, cycle.size());
  for (const char* part : {"/metrics/", "/cycle/metrics/"}) {
    add(part, metrics, metrics.size());
    add(std::string(part) + "full_scale/", metrics, at_full_scale);
  }
  return all;
}

bool begins_with(const std::string& text, const std::string& part) {
  return text.size() > part.size() && text.compare(0, part.size(), part) == 0;
}

// Empty where a result has it. `part` is the first word of the pointer, with its slashes.
std::string unknown_number(const std::string& at, const std::string& part) {
  std::vector<std::string> names;
  for (const std::string& known : numbers_of_results()) {
    if (known == at || begins_with(at, process_of_cycle)) return "";
    if (begins_with(known, part)) names.push_back(known.substr(part.size()));
  }
  return "which is no number of a result" + did_you_mean(at.substr(part.size()), names) + "; below " +
         part.substr(0, part.size() - 1) + " are " + listed(names);
}

double bound(const Json& entry, const char* key, double none, const std::string& at, Mistakes& mistakes) {
  if (!entry.contains(key)) return none;
  const Json& value = entry.at(key);
  if (value.is_number()) return value.get<double>();
  mistakes.push_back({at + "/" + key, "is " + shown(value) + ", must be a number" + number_meant_by(value)});
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

const std::vector<std::string>& numbers_of_results() {
  static const std::vector<std::string> all = all_numbers();
  return all;
}

std::string lacking_number(const StudySpec& spec, const std::string& at) {
  const bool loads = spec.use_cycle || spec.use_peridynamics;
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"/hull/margins/", ""},
      {"/hydrostatics/", ""},
      {"/lindqvist/", spec.use_lindqvist ? "" : "needs \"lindqvist\" in /evaluators"},
      {"/cycle/", spec.use_cycle ? "" : "needs \"cycle\" in /evaluators"},
      {"/metrics/", loads ? "" : "needs \"cycle\" or \"peridynamics\" in /evaluators"}};
  for (const auto& [part, lacks] : parts)
    if (begins_with(at, part)) return lacks.empty() ? unknown_number(at, part) : lacks;
  for (const ProgramEvaluator& program : spec.programs)
    if (begins_with(at, "/programs/" + program.name + "/")) return "";
  if (begins_with(at, "/programs/")) return "needs a program of that name in /evaluators";
  return "must be the pointer of a number in a result, below /hull/margins, /hydrostatics, /lindqvist, "
         "/cycle, /metrics/full_scale or /programs/NAME";
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
