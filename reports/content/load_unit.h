// One unit for the loads of a whole report, so that columns compare at a glance.
#pragma once

#include <string>

#include "study/plan/ranking.h"

namespace icebow {

struct LoadUnit {
  std::string name;  // "MN"
  double newtons = 1e6;
  int decimals = 3;
};

// MN, or kN where no load reaches 0.1 MN.
LoadUnit load_unit(const Ranking& ranking);

// "0.812 MN" of newtons; a load too small for the unit's decimals keeps two digits ("0.00012 MN").
std::string load_in_words(double newtons, const LoadUnit& unit);
// The same without the unit, of a number in it.
std::string load_number(double value, const LoadUnit& unit);

// "0.812 ± 0.064", without unit; "0.812" where there is no interval.
std::string with_interval(double value, double half_width, int decimals);
// Decimals at which the half width keeps one significant digit (two where it starts with 1), at least
// `least`.
int decimals_for_interval(double half_width, int least, int most);

// "mean ice load", "mean ice load per metre of beam" ...: what the designs are ranked by.
std::string ranked_quantity(const std::string& rank_by);
// A load of a result by its pointer, like "/programs/yard/resistance_N".
bool is_own_number(const std::string& rank_by);
// Half width of the 95 % interval of RankedDesign::value [unit of value]; NaN where unknown.
double value_ci95(const RankedDesign& row, const std::string& rank_by);

// What the second objective is called, its unit, and how many of a result's unit make one of that.
struct SecondQuantity {
  std::string words, unit;
  double size = 1.0;
};
SecondQuantity second_quantity(const Ranking& ranking, const LoadUnit& load);

}  // namespace icebow
