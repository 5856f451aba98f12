// Which part of a study's box of variables has feasible bows.
#pragma once

#include <string>
#include <vector>

#include "study/spec/study_spec.h"

namespace icebow {

struct FeasibleBox {
  int tried = 0, feasible = 0;  // points of the whole box
  std::vector<Variable>
      variables;         // bounds within which every point that was tried is feasible; empty: none found
  int tried_inside = 0;  // points tried there
  // Where the study holds a displacement: which dimension follows, and its values at the feasible points, in
  // the file's unit.
  std::string held;
  double held_lower = 0.0, held_upper = 0.0;
};

// Tries the closed-form margins at random points, the same every time; where some are infeasible, draws the
// bounds in, the side at a time that loses the fewest feasible points for the infeasible ones it leaves out,
// and tries the smaller box anew. Nothing is tried where the study has no ranges or its hull is a file.
FeasibleBox feasible_box(const StudySpec& spec);

}  // namespace icebow
