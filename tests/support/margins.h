// A bow's margins by their names, and the numbers in their advice.
#pragma once

#include <limits>
#include <regex>
#include <string>

#include "hullgen/bow/feasibility.h"

namespace icebow {

inline Margin margin(const BowParameters& bow, const std::string& name) {
  for (const Margin& g : check_feasibility(bow).margins)
    if (g.name == name) return g;
  return {};
}

// The number after these words and "at least" or "at most".
inline double advised(const std::string& words, const std::string& after) {
  std::smatch found;
  const std::regex pattern(after + " at (?:least|most) ([0-9.]+)");
  return std::regex_search(words, found, pattern) ? std::stod(found[1])
                                                  : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace icebow
