// The hull of a case: generated from its bow's angles, or the user's own.
#pragma once

#include "study/spec/study_spec.h"

namespace icebow {

// Whether angles were asked of a hull of the user's own that differ from those it has.
bool is_deformed(const Case& c);

// Never throws for an impossible bow or deformation: the status says so.
Hull make_hull(const Case& c);

// What is known before there is a mesh; a hull of the user's own exists, and whether it
// can be deformed is known when it is.
BowFeasibility check_feasibility(const Case& c);

}  // namespace icebow
