// The log of a race, as the store keeps it: what it has decided, and how far each voyage is to be sailed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"

namespace icebow {

enum class RaceState {
  none,     // the study has no race
  sailing,  // not over
  decided,  // the leader is at most best_within above the best
  budget,   // not decided, and the core hours are spent
  longest   // not decided, and no open voyage may be sailed farther
};

struct RaceLeg {
  std::map<std::string, double> sailed;  //!< by design: so far, full scale [m]
  std::vector<std::string> in;           // designs that may be the best, after this leg
  std::string leader;
  double most_above_best = 0.0;          // of the leader's load; infinite where a record is too short to say
  double core_hours = 0.0;               // of all voyages so far
  std::map<std::string, double> drifts;  // by design whose record drifts: second half over first, minus 1
};

struct RaceRecord {
  RaceState state = RaceState::none;
  double best_within = 0.0, confidence = 0.0, budget_core_hours = 0.0;
  std::vector<RaceLeg> legs;
  std::map<std::string, std::string> keys;  // by name, of the designs that race
  std::map<std::string, double> targets;    //!< by key: how far the voyage is to be sailed, full scale [m]

  bool given() const { return state != RaceState::none && !legs.empty(); }
};

bool is_in(const RaceLeg& leg, const std::string& design);

Json to_json(const RaceRecord& record);
// Reads what to_json() made; a record without a race where `json` is null.
RaceRecord race_record_from_json(const Json& json);

// "Decided: d003 is at most 4 % above the lowest mean load of 10 designs ..."; empty where there was no race.
std::string race_in_words(const RaceRecord& record);

// What is said of one design: "leads", "may be the lowest", "drifts, may be the lowest", "out in leg 2";
// empty where it did not race.
std::string place_in_race(const RaceRecord& record, const std::string& design);

}  // namespace icebow
