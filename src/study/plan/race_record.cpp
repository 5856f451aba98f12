#include "study/plan/race_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/json_fields.h"
#include "base/text.h"

namespace icebow {
namespace {

const std::vector<std::pair<RaceState, std::string>>& state_words() {
  static const std::vector<std::pair<RaceState, std::string>> words = {{RaceState::sailing, "sailing"},
                                                                       {RaceState::decided, "decided"},
                                                                       {RaceState::budget, "budget"},
                                                                       {RaceState::longest, "longest"}};
  return words;
}

Json lengths_json(const std::map<std::string, double>& lengths) {
  Json json = Json::object();
  for (const auto& [name, length] : lengths) json[name] = length;
  return json;
}

std::map<std::string, double> lengths_from(const Json& json) {
  std::map<std::string, double> lengths;
  for (const auto& [name, length] : json.items()) lengths[name] = length.get<double>();
  return lengths;
}

std::string others_in_words(const RaceLeg& leg) {
  std::vector<std::string> others;
  for (const std::string& name : leg.in)
    if (name != leg.leader) others.push_back(name);
  if (others.size() > 4) return std::to_string(others.size()) + " others may be lower";
  std::string words;
  for (std::size_t n = 0; n < others.size(); ++n)
    words += (n == 0 ? "" : n + 1 == others.size() ? " and " : ", ") + others[n];
  return words.empty() ? "" : words + " may be lower";
}

std::string so_far(const RaceRecord& record) {
  const RaceLeg& last = record.legs.back();
  return text("%d leg%s, %.3g core hours", static_cast<int>(record.legs.size()),
              record.legs.size() == 1 ? "" : "s", last.core_hours);
}

std::string above(const RaceLeg& leg) {
  if (!std::isfinite(leg.most_above_best))
    return std::string("; the records ") + (leg.drifts.empty() ? "are too short" : "drift or are too short") +
           " to say how far above the best";
  return text(", and is at most %.0f %% above the lowest mean load", std::ceil(100.0 * leg.most_above_best));
}

// Of designs that may be the best.
std::string drifts_in_words(const RaceLeg& leg) {
  std::string words;
  for (const auto& [name, relative] : leg.drifts) {
    if (!is_in(leg, name)) continue;
    words += (words.empty() ? " The load of " : ", of ") + name;
    if (std::isfinite(relative))
      words += text(" (its second half %.0f %% %s the first)", 100.0 * std::fabs(relative),
                    relative > 0.0 ? "above" : "below");
  }
  return words.empty()
             ? ""
             : words + " drifts where it is counted, so it neither wins nor puts another one out: " +
                   "sail on, or let the counted part begin later (operation.steady_from_m).";
}

std::string why_it_ended(const RaceRecord& record) {
  switch (record.state) {
    case RaceState::budget:
      return text(
          "The budget of %g core hours is spent (decide.budget_core_h): raise it, and the same "
          "command sails on.",
          record.budget_core_hours);
    case RaceState::longest:
      return "No open voyage may be sailed farther (decide.longest_m): raise it, and the same command sails "
             "on.";
    default:
      return "The same command sails on.";
  }
}

}  // namespace

bool is_in(const RaceLeg& leg, const std::string& design) {
  return std::find(leg.in.begin(), leg.in.end(), design) != leg.in.end();
}

Json to_json(const RaceRecord& record) {
  if (record.state == RaceState::none) return nullptr;
  Json legs = Json::array();
  for (const RaceLeg& leg : record.legs)
    legs.push_back({{"sailed_to_m", lengths_json(leg.sailed)},
                    {"in", leg.in},
                    {"leader", leg.leader},
                    {"drifts", lengths_json(leg.drifts)},
                    {"most_above_best", finite_or_null(leg.most_above_best)},
                    {"core_hours", leg.core_hours}});
  std::string state;
  for (const auto& [value, word] : state_words())
    if (value == record.state) state = word;
  return {{"state", state},
          {"best_within", record.best_within},
          {"confidence", record.confidence},
          {"budget_core_h", record.budget_core_hours},
          {"legs", legs},
          {"keys", record.keys},
          {"targets_m", lengths_json(record.targets)}};
}

RaceRecord race_record_from_json(const Json& json) {
  RaceRecord record;
  if (!json.is_object()) return record;
  for (const auto& [value, word] : state_words())
    if (json.at("state") == word) record.state = value;
  record.best_within = json.at("best_within");
  record.confidence = json.at("confidence");
  record.budget_core_hours = json.at("budget_core_h");
  for (const Json& one : json.at("legs")) {
    RaceLeg leg;
    leg.sailed = lengths_from(one.at("sailed_to_m"));
    leg.in = one.at("in").get<std::vector<std::string>>();
    if (one.contains("drifts")) leg.drifts = lengths_from(one.at("drifts"));
    leg.leader = one.at("leader").get<std::string>();
    const double most = number_at(one, "/most_above_best");
    leg.most_above_best = std::isfinite(most) ? most : std::numeric_limits<double>::infinity();
    leg.core_hours = one.at("core_hours");
    record.legs.push_back(leg);
  }
  record.keys = json.at("keys").get<std::map<std::string, std::string>>();
  record.targets = lengths_from(json.at("targets_m"));
  return record;
}

std::string race_in_words(const RaceRecord& record) {
  if (!record.given()) return "";
  const RaceLeg& last = record.legs.back();
  const int designs = static_cast<int>(last.sailed.size());
  const std::string sure =
      text(" of %d designs, at a confidence of %.4g %% (", designs, 100.0 * record.confidence) +
      so_far(record) + ").";
  if (record.state == RaceState::decided && last.in.size() == 1)
    return "Decided: " + last.leader + " has the lowest mean load" + sure + drifts_in_words(last);
  if (record.state == RaceState::decided)
    return "Decided: " + last.leader +
           text(" is at most %.3g %% above the lowest mean load", 100.0 * last.most_above_best) + sure +
           drifts_in_words(last);
  return "Not decided: " + last.leader + " leads" + above(last) + sure + " " + others_in_words(last) + "." +
         drifts_in_words(last) + " " + why_it_ended(record);
}

std::string place_in_race(const RaceRecord& record, const std::string& design) {
  if (!record.given() || record.legs.back().sailed.count(design) == 0) return "";
  const bool drifts = record.legs.back().drifts.count(design) > 0;
  if (record.legs.back().leader == design) return drifts ? "leads, but drifts" : "leads";
  for (std::size_t n = 0; n < record.legs.size(); ++n)
    if (!is_in(record.legs[n], design)) return "out in leg " + std::to_string(n + 1);
  return drifts ? "drifts, may be the lowest" : "may be the lowest";
}

}  // namespace icebow
