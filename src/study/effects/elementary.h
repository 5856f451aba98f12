// Elementary effects (Morris 1991): what one step of a parameter does, at many places of the box.
#pragma once

#include <string>
#include <vector>

#include "study/plan/ranking.h"

namespace icebow {

struct ElementaryEffects {
  std::string pointer;
  int steps = 0;  // pairs of designs that differ in this parameter alone, by two thirds of its range
  // Of the change over the whole range that each step amounts to [unit of the ranked value]: mean, standard
  // deviation (NaN for one step; large where the parameter acts unlike at different places), mean size with
  // the half width of its 95 % interval.
  double mean = 0.0, deviation = 0.0, mean_size = 0.0, mean_size_ci95 = 0.0;
};

// Of the ranked designs, largest mean size first; parameters without a step are left out. Meant for the
// designs of the method "morris"; of more than 5,000 designs nothing is looked at.
std::vector<ElementaryEffects> elementary_effects(const Ranking& ranking);

}  // namespace icebow
