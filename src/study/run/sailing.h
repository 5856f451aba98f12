// The stored row of a voyage that may be sailed on: how far it went, and whether it can go farther.
#pragma once

#include <string>

#include "study/plan/design_space.h"
#include "study/store/store.h"

namespace icebow {

// The first leg of a voyage is the same whether the study sails on or not: a result of the other kind is
// taken over under the design's own key.
void adopt_first_leg(Store& store, const PlannedDesign& planned);

// True of what is no voyage of a race, too, and of a row without a result.
bool is_far_enough(const PlannedDesign& planned, const Evaluation& stored);

// It has failed when it was to be sailed on.
bool has_ended(const Evaluation& stored);

// Notes so, and returns words for the user. What has been sailed stands.
std::string end_sailing(Evaluation& stored, const std::string& reason);

}  // namespace icebow
