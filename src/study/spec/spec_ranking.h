// The part of a study file that says what designs are compared by.
#pragma once

#include "study/spec/spec_section.h"
#include "study/spec/study_spec.h"

namespace icebow {

// Fills spec.rank_by and spec.second. Notes its mistakes; where the evaluators are not known, what they are
// needed for is not looked at.
void read_ranking(const Json& document, StudySpec& spec, bool evaluators_known, Mistakes& mistakes);

// {"by": "...", "best": "smallest"}, as a store keeps it; null where there is none.
Json to_json(const SecondObjective& second);
SecondObjective second_objective_from(const Json& json);

}  // namespace icebow
