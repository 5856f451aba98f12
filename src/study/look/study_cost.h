// What a study takes on this machine, by a measurement of its own first design.
#pragma once

#include <string>

#include "study/plan/design_space.h"
#include "study/spec/study_spec.h"

namespace icebow {

struct DesignCost {
  double core_s = 0.0;      //!< on one core that has nothing else to do [s]
  double bytes = 0.0;       // of its files, its row of the store included
  double checkpoint = 0.0;  //!< beside them while it is simulated, and after where a race sails it on [bytes]
};

struct StudyCost {
  std::string unknown;  // why nothing could be measured, in words; empty where it was
  DesignCost design;    // of the plan and of its method
  int designs = 0;      // of these at most, repeats and what a method may still propose included; of a race,
                        // first legs
  DesignCost confirmation;  // a simulation that follows a sweep of the cycle
  int confirmations = 0;    // of these
  bool programs = false;    // programs of the user's own evaluate as well: their time is not in it
};

// The same of one design, its repeats by the study included.
StudyCost design_cost(const StudySpec& spec, Design design, double seconds);

// Evaluates the file's own design: the formula and the cycle to their end, a simulation for `seconds` after
// the hull and the ice are made, which takes some seconds more. Of a simulation only the first steps are
// measured; docs/study_file.md says by what its later ones, in broken ice, are counted more. Writes to a
// directory that it removes.
StudyCost study_cost(const StudySpec& spec, const StudyPlan& plan, double seconds);

}  // namespace icebow
