// In which ice, how simulated, the designs of a study were judged.
#pragma once

#include <string>
#include <vector>

#include "reports/content/study_results.h"

namespace icebow {

struct Fact {
  std::string label, value;
};

struct Conditions {
  std::vector<Fact> shared;  // ship, ice and speed; "from to" where designs differ
  std::vector<Fact>
      simulated;    // strength, modulus, model, lattice, water, sheet, seeds; empty where nothing was
  std::string ice;  // the same in one line; empty likewise
  std::string
      unlike_ices;  // where simulation and formula stand in different ice, and how far apart; else empty
  std::string unlike_ships;  // where ship, ice or speed differ within the ranking; else empty
};

Conditions conditions(const StudyResults& study);
// " over 2 scenarios, by their worst" of a study file with scenarios, else nothing.
std::string over_scenarios(const Json& document);

// "simulated in ice of 5952 kPa, the formula in ice of 863 kPa" where they differ by more than a quarter;
// else empty.
std::string unlike_ice_words(const Json& result);

}  // namespace icebow
