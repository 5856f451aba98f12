// The Pareto front of designs with two objectives, of which each may be known with an error.
#pragma once

#include <string>
#include <vector>

#include "solver/model/mean_difference.h"

namespace icebow {

// Smaller is better; a standard error of 0 is an exact number, one that is not finite an unknown error.
struct Objectives {
  MeanEstimate first, second;
};

enum class FrontPlace {
  none,       // has no place: a number is missing
  front,      // no other design is as good in both and better in one
  open,       // another one is, but not beyond the intervals of their differences
  dominated,  // another one surely is
};
// "front", "open", "dominated"; "" for none.
const char* to_string(FrontPlace place);

// Whether `a` is surely as good as `b` in both and better in one: exact numbers are compared as they are,
// others by Welch's test (p below told_apart_below, each pair of designs by itself).
bool surely_dominates(const Objectives& a, const Objectives& b);

// Objectives with a mean that is not finite get `none`. The time grows with the square of the number of
// designs where no two are told apart, else with the number times that of the front.
std::vector<FrontPlace> front_places(const std::vector<Objectives>& designs);

}  // namespace icebow
